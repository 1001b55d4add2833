#include "app/step_states.h"

#include "app/review/tracked_pose.h"
#include "core/case/case_patients.h"
#include "core/registration/judging/unopacified_branches.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>

namespace angiopose::app {
namespace {

using ui::StepMark;
using ui::StepState;

struct StepWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::StepStates)
};

StepState vessels(const core::Case& current, const StepInputs& inputs)
{
    if (!current.vessels.tree && current.vessels.scan) {
        return {StepMark::Attention, StepWords::tr("not traced"),
                StepWords::tr("No vessels were traced in the scan. Place a seed or set the threshold in the panel next "
                              "to the slices.")};
    }
    if (!current.vessels.tree) {
        return {StepMark::Open, {}, StepWords::tr("Open a CT angiogram, a segmentation, a surface or a centerline.")};
    }
    if (inputs.treePieces > 1) {
        return {StepMark::Attention, StepWords::tr("%1 components").arg(inputs.treePieces),
                StepWords::tr("The vessel tree is not connected. The note below the branch list explains how to join "
                              "the components of the tree.")};
    }
    const auto count = static_cast<int>(current.vessels.tree->branches.size());
    return {StepMark::Done, count == 1 ? StepWords::tr("1 branch") : StepWords::tr("%1 branches").arg(count), {}};
}

StepState angiogram(const core::Case& current, const StepInputs& inputs)
{
    if (!current.shown().angiogram) {
        return {StepMark::Open, {}, StepWords::tr("Open an angiogram: DICOM XA, PNG or TIFF.")};
    }
    if (!inputs.targetProblem.isEmpty()) {
        return {StepMark::Attention, StepWords::tr("no vessels traced"), inputs.targetProblem};
    }
    if (inputs.isTracing) {
        return {StepMark::Open, StepWords::tr("tracing…"), {}};
    }
    if (const auto mismatch = core::findMismatch(current); !mismatch.empty()) {
        return {StepMark::Attention, StepWords::tr("different patient?"), ui::messagesText(mismatch)};
    }
    if (core::givenTargetOf(current.shown())) {
        return {StepMark::Done,
                current.shown().target.editedFrame ? StepWords::tr("frame %1, edited").arg(current.shown().frame + 1)
                                                   : StepWords::tr("imported centerline"),
                {}};
    }
    if (!inputs.targetWarning.isEmpty()) {
        return {StepMark::Attention, StepWords::tr("no contrast?"), inputs.targetWarning};
    }
    return {StepMark::Done, StepWords::tr("frame %1").arg(current.shown().frame + 1), {}};
}

bool isAssumed(const core::CArm& cArm)
{
    for (const auto* value : {&cArm.sourceToDetectorMm, &vesselDepthOf(cArm), &cArm.columnSpacingMm,
                              &cArm.primaryAngleDeg, &cArm.secondaryAngleDeg}) {
        if (value->origin == core::Origin::Assumed) {
            return true;
        }
    }
    return false;
}

StepState geometry(const core::Case& current)
{
    if (!current.shown().angiogram) {
        return {};
    }
    if (const auto camera = core::cameraOf(current.shown()); !camera) {
        return {StepMark::Attention, StepWords::tr("incomplete"), ui::messageText(camera.error().message)};
    }
    if (current.shown().geometry.cameraOverride) {
        return {StepMark::Done, StepWords::tr("from the case"), {}};
    }
    if (const auto contradictions = core::contradictionsOf(current.shown()); !contradictions.empty()) {
        return {StepMark::Attention, StepWords::tr("inconsistent"), ui::messageText(contradictions.front())};
    }
    if (isAssumed(current.shown().geometry.cArm)) {
        return {StepMark::Attention, StepWords::tr("partly assumed"),
                StepWords::tr("Some values are assumed. Enter the actual values if you know them.")};
    }
    switch (current.shown().geometry.cArm.columnSpacingMm.origin) {
        case core::Origin::User:
            return {StepMark::Done, StepWords::tr("pixel spacing entered"), {}};
        case core::Origin::Derived:
            return {StepMark::Attention, StepWords::tr("pixel spacing derived"),
                    StepWords::tr("The header contains no pixel spacing: %1. Enter the pixel spacing, or press Enter "
                                  "in the field to confirm the value.")
                        .arg(QString::fromStdString(current.shown().geometry.cArm.columnSpacingMm.basis))};
        default:
            return {StepMark::Done, StepWords::tr("from the header"), {}};
    }
}

StepState initialPose(const core::Case& current)
{
    if (!current.vessels.tree || !current.shown().angiogram) {
        return {};
    }
    if (const auto start = core::initialPoseOf(current); !start) {
        return {StepMark::Attention, StepWords::tr("missing"), ui::messageText(start.error().message)};
    }
    return {StepMark::Done,
            current.shown().initialCameraFromPatient
                ? current.shown().landmarks.empty() ? StepWords::tr("from the case") : StepWords::tr("from landmarks")
                : StepWords::tr("from angles"),
            {}};
}

StepState registration(const core::Case& current, const StepInputs& inputs)
{
    if (inputs.isRunning) {
        return {StepMark::Open, StepWords::tr("running…"), {}};
    }
    if (!current.shown().result) {
        if (const core::TrackedRunFrame* frame = shownTrackedPose(current.shown())) {
            return {frame->tracked.isTrustworthy ? StepMark::Done : StepMark::Attention, StepWords::tr("tracked"), {}};
        }
        return {StepMark::Open, inputs.poseEdited ? StepWords::tr("moved manually") : QString(), {}};
    }
    const core::RegistrationResult& result = *current.shown().result;
    const double ms = result.time.totalMs;
    const QString time = ms < 1000.0 ? StepWords::tr("%1 ms").arg(ui::numberText(ms, ms < 10.0 ? 1 : 0))
                                     : StepWords::tr("%1 s").arg(ui::numberText(ms / 1000.0, 1));
    return result.trustworthy
               ? StepState{StepMark::Done, time, {}}
               : StepState{StepMark::Attention, time,
                           result.warnings.empty() ? QString() : ui::messageText(result.warnings.front())};
}

StepState review(const core::Case& current)
{
    const auto& last = current.shown().result;
    if (!last) {
        return {};
    }
    const core::RegistrationResult* const result = core::resultOfShownFrame(current.shown());
    if (!result) {
        return {StepMark::Attention, StepWords::tr("different frame"),
                StepWords::tr("This pose was registered in frame %1. Press R to register in the displayed frame.")
                    .arg(last->provenance.frame.value_or(0) + 1)};
    }
    if (!result->trustworthy) {
        const auto& warnings = result->warnings;
        return {StepMark::Attention, StepWords::tr("NOT RELIABLE"),
                warnings.empty() ? QString() : ui::messageText(warnings.front())};
    }
    const QString median = ui::numberText(result->metrics.medianMm, 2);
    const double share = core::assessedFraction(*result);
    return {StepMark::Done,
            share < 1.0 ? StepWords::tr("%1 mm median over %2 %").arg(median, ui::numberText(100.0 * share, 0))
                        : StepWords::tr("%1 mm median").arg(median),
            {}};
}

}   // namespace

std::array<ui::StepState, ui::stepCount> stepStates(const core::Case& current, const StepInputs& inputs)
{
    const StepState exported = inputs.exported ? StepState{StepMark::Done, StepWords::tr("exported"), {}} : StepState{};
    return {vessels(current, inputs),
            angiogram(current, inputs),
            geometry(current),
            initialPose(current),
            registration(current, inputs),
            review(current),
            exported};
}

}   // namespace angiopose::app
