#include "ui/theme/without_style_sheet.h"

#include <QApplication>

namespace angiopose::ui {

WithoutStyleSheet::WithoutStyleSheet() : sheet_(qApp->styleSheet())
{
    qApp->setStyleSheet({});
}

WithoutStyleSheet::~WithoutStyleSheet()
{
    qApp->setStyleSheet(sheet_);
}

}   // namespace angiopose::ui
