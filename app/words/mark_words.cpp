#include "app/words/mark_words.h"

#include "core/messages/messages.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace angiopose::app {
namespace {

struct MarkWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::MarkWords)
};

constexpr double manySigmas = 2.0;

QString placeWords(const core::VesselMark& mark)
{
    return ui::messageText(core::messages::markPosition(core::inMm(mark.pointInPatient.x(), 1),
                                                        core::inMm(mark.pointInPatient.y(), 1),
                                                        core::inMm(mark.pointInPatient.z(), 1)));
}

QString kindWords(const core::ImageAnnotation& annotation)
{
    return annotation.kind == core::AnnotationKind::Arrow ? MarkWords::tr("arrow") : MarkWords::tr("text");
}

QString frameWordsOf(const core::ImageAnnotation& annotation)
{
    return MarkWords::tr("Shown on frame %1 of this view and in every image exported from it.")
        .arg(annotation.frame + 1);
}

bool isFarther(double mm, const std::optional<double>& claimedMm)
{
    return claimedMm && mm > manySigmas * *claimedMm;
}

/// Returns whether the error exceeds twice the stated uncertainty of the pose, in the shown view or in 3-D.
bool exceedsUncertainty(const core::TargetPointResult& checked, std::size_t shownView)
{
    const auto shown = std::ranges::find(checked.views, shownView, &core::TargetPointViewResult::view);
    const bool isHere = shown != checked.views.end() && shown->error && shown->predicted &&
                        isFarther(shown->error.value().mm, shown->predicted->inPlaneMm);
    return isHere || (checked.triangulated && isFarther(checked.spaceMm(), checked.predictedSpaceMm));
}

}   // namespace

ui::MarkRow annotationRow(const core::ImageAnnotation& annotation)
{
    return {QString::fromStdString(annotation.text), kindWords(annotation), frameWordsOf(annotation), false};
}

QString targetPointSentences(const core::TargetPointResult& checked, std::size_t viewCount)
{
    QStringList sentences;
    for (const core::TargetPointViewResult& view : checked.views) {
        const QString reported = ui::messagesText(core::sentencesOf(view));
        sentences << (viewCount > 1 ? MarkWords::tr("View %1:").arg(view.view + 1) + QLatin1Char(' ') + reported
                                    : reported);
    }
    if (viewCount > 1 || checked.views.empty()) {
        sentences << ui::messagesText(core::spaceErrorMessages(checked));
    }
    return ui::joinSentences(sentences);
}

ui::MarkRow markRow(const core::VesselMark& mark, const std::vector<core::TargetPointResult>& checked,
                    std::size_t shownView)
{
    const QString name = QString::fromStdString(mark.name);
    if (mark.kind == core::VesselMarkKind::OstiumRing) {
        return {name, ui::messageText(core::messages::ringWidth(core::inMm(2.0 * mark.radiusMm, 1))), placeWords(mark),
                false};
    }
    const auto found = std::ranges::find(
        checked, mark.id, [](const core::TargetPointResult& checkedPoint) { return checkedPoint.mark.id; });
    if (found == checked.end()) {
        return {name, QStringLiteral("–"), placeWords(mark), false};
    }
    const auto label = core::labelOf(*found, shownView);
    const std::size_t views = found->views.size() + (found->views.size() == 1 && found->triangulated ? 1 : 0);
    return {name, label ? ui::messageText(*label) : QStringLiteral("–"),
            ui::joinSentences({targetPointSentences(*found, std::max<std::size_t>(views, 1)), placeWords(mark)}),
            exceedsUncertainty(*found, shownView)};
}

QString unusedMarkName(core::VesselMarkKind kind, const std::vector<core::VesselMark>& marks)
{
    const bool isRing = kind == core::VesselMarkKind::OstiumRing;
    for (int number = 1;; ++number) {
        const QString name = (isRing ? MarkWords::tr("Ostium %1") : MarkWords::tr("Target point %1")).arg(number);
        if (std::ranges::find(marks, name.toStdString(), &core::VesselMark::name) == marks.end()) {
            return name;
        }
    }
}

}   // namespace angiopose::app
