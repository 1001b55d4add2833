#include "ui/words/terms.h"

#include "core/registration/methods/method_info.h"

#include <QCoreApplication>

namespace angiopose::ui {
namespace {

struct MethodWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::ui::MethodWords)
};

}   // namespace

QString methodName(const std::string& methodId)
{
    if (methodId.empty()) {
        return MethodWords::tr("manual");
    }
    for (const core::MethodInfo& info : core::methodInfos()) {
        if (info.id == methodId) {
            return QString::fromUtf8(info.label.data(), static_cast<qsizetype>(info.label.size()));
        }
    }
    return QString::fromStdString(methodId);
}

QString termText(std::string_view term)
{
    return QCoreApplication::translate("core", std::string(term).c_str());
}

QString termText(const QString& term)
{
    return QCoreApplication::translate("core", term.toUtf8().constData());
}

}   // namespace angiopose::ui
