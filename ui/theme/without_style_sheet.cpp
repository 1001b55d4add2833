#include "ui/theme/without_style_sheet.h"

#include <QApplication>
#include <QWidget>

#include <algorithm>

namespace angiopose::ui {

WithoutStyleSheet::WithoutStyleSheet()
{
    const QWidgetList windows = QApplication::topLevelWidgets();
    if (std::ranges::none_of(windows, [](const QWidget* window) { return window->isVisible(); })) {
        sheet_ = qApp->styleSheet();
        qApp->setStyleSheet({});
    }
}

WithoutStyleSheet::~WithoutStyleSheet()
{
    if (sheet_) {
        qApp->setStyleSheet(*sheet_);
    }
}

}   // namespace angiopose::ui
