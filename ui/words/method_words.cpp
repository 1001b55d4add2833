#include "ui/words/method_words.h"

#include "core/registration/methods/method_info.h"

#include <QCoreApplication>

namespace angiopose::ui {
namespace {

struct MethodWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::ui::MethodWords)
};

}   // namespace

QString methodWords(const std::string& methodId)
{
    if (methodId.empty()) {
        return MethodWords::tr("by hand");
    }
    for (const core::MethodInfo& info : core::methodInfos()) {
        if (info.id == methodId) {
            return QString::fromUtf8(info.label.data(), static_cast<qsizetype>(info.label.size()));
        }
    }
    return QString::fromStdString(methodId);
}

}   // namespace angiopose::ui
