#include "app/words/view_words.h"

#include "app/texts/number_text.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QFileInfo>

namespace angiopose::app {

QString fileNameOf(const core::View& view)
{
    const std::string& path = view.imageFile.path.empty() ? view.caseFile.path : view.imageFile.path;
    return QFileInfo(QString::fromStdString(path)).fileName();
}

QString anglesOf(const core::View& view)
{
    const core::CArm& cArm = view.geometry.cArm;
    if (!cArm.primaryAngleDeg.value || !cArm.secondaryAngleDeg.value) {
        return fileNameOf(view);
    }
    return ui::withDecimalSign(QString::fromStdString(primaryAngleText(*cArm.primaryAngleDeg.value)) +
                               QStringLiteral(" · ") +
                               QString::fromStdString(secondaryAngleText(*cArm.secondaryAngleDeg.value)));
}

QString numberedTitle(const std::vector<core::View>& views, std::size_t index)
{
    const core::View& view = views[index];
    const QString title = view.name.empty() ? anglesOf(view) : QString::fromStdString(view.name);
    const QString number = QString::number(index + 1);
    return title.isEmpty() ? number : number + QStringLiteral(" · ") + title;
}

ui::CornerTexts windowTexts(const CornerLines& lines)
{
    ui::CornerTexts texts =
        toCornerTexts(lines, [](const core::Message& message) { return ui::messageText(message).toStdString(); });
    texts.decimalSign = ui::languageLocale().decimalPoint() == QLatin1String(",") ? ',' : '.';
    return texts;
}

}   // namespace angiopose::app
