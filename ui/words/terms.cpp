#include "ui/words/terms.h"

#include <QCoreApplication>

namespace angiopose::ui {

QString termText(std::string_view term)
{
    return QCoreApplication::translate("core", std::string(term).c_str());
}

QString termText(const QString& term)
{
    return QCoreApplication::translate("core", term.toUtf8().constData());
}

}   // namespace angiopose::ui
