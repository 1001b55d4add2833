#include "app/step_states.h"

#include "core/imaging/patient_match.h"

#include <QCoreApplication>

namespace app {
namespace {

using ui::StepMark;
using ui::StepState;

QString text(const char* words, int n = -1)
{
    return QCoreApplication::translate("app::StepStates", words, nullptr, n);
}

StepState vessels(const core::RegistrationCase& current, const StepFacts& facts)
{
    if (!current.tree) {
        return {StepMark::Open, {}, text("Open a CT angiogram, a segmentation, a surface or a centreline.")};
    }
    if (facts.treePieces > 1) {
        return {StepMark::Look, text("%1 pieces").arg(facts.treePieces),
                text("The vessels are in pieces. Below the branch list is how to join them.")};
    }
    const auto count = static_cast<int>(current.tree->branches.size());
    return {StepMark::Done, count == 1 ? text("1 branch") : text("%1 branches").arg(count), {}};
}

StepState angiogram(const core::RegistrationCase& current, const StepFacts& facts)
{
    if (!current.angiogram) {
        return {StepMark::Open, {}, text("Open an angiogram: DICOM XA, PNG or TIFF.")};
    }
    if (!facts.targetProblem.isEmpty()) {
        return {StepMark::Look, text("no vessels traced"), facts.targetProblem};
    }
    if (facts.isTracing) {
        return {StepMark::Open, text("tracing …"), {}};
    }
    if (const std::string mismatch = core::findMismatch(current.scanIdentity, current.angiogram->identity);
        !mismatch.empty()) {
        return {StepMark::Look, text("another patient?"), QString::fromStdString(mismatch)};
    }
    if (core::givenTargetOf(current)) {
        return {StepMark::Done,
                current.editedFrame ? text("frame %1, edited").arg(current.frame) : text("given centreline"),
                {}};
    }
    return {StepMark::Done, text("frame %1").arg(current.frame), {}};
}

bool isAssumed(const core::CArm& cArm)
{
    for (const auto* value : {&cArm.sourceToDetectorMm, &cArm.sourceToPatientMm, &cArm.columnSpacingMm,
                              &cArm.primaryAngleDeg, &cArm.secondaryAngleDeg}) {
        if (value->origin == core::Origin::Assumed) {
            return true;
        }
    }
    return false;
}

StepState geometry(const core::RegistrationCase& current)
{
    if (!current.angiogram) {
        return {};
    }
    if (const auto camera = core::cameraOf(current); !camera) {
        return {StepMark::Look, text("incomplete"), QString::fromStdString(camera.error().message)};
    }
    if (current.cameraOverride) {
        return {StepMark::Done, text("from the case"), {}};
    }
    if (const auto contradictions = core::contradictionsOf(current); !contradictions.empty()) {
        return {StepMark::Look, text("contradictory"), QString::fromStdString(contradictions.front())};
    }
    if (isAssumed(current.cArm)) {
        return {StepMark::Look, text("partly assumed"), text("Some values are assumed. Type them if you know them.")};
    }
    switch (current.cArm.columnSpacingMm.origin) {
        case core::Origin::User:
            return {StepMark::Done, text("pixel spacing typed"), {}};
        case core::Origin::Derived:
            return {StepMark::Look, text("pixel spacing derived"),
                    text("The header gives no pixel spacing: %1. Type it, or press Enter in the field to confirm it.")
                        .arg(QString::fromStdString(current.cArm.columnSpacingMm.basis))};
        default:
            return {StepMark::Done, text("from the header"), {}};
    }
}

StepState startPose(const core::RegistrationCase& current)
{
    if (!current.tree || !current.angiogram) {
        return {};
    }
    if (const auto start = core::startPoseOf(current); !start) {
        return {StepMark::Look, text("missing"), QString::fromStdString(start.error().message)};
    }
    return {StepMark::Done,
            current.hasInitialPose ? current.landmarks.empty() ? text("from the case") : text("from landmarks")
                                   : text("from angles"),
            {}};
}

StepState registration(const core::RegistrationCase& current, const StepFacts& facts)
{
    if (facts.isRunning) {
        return {StepMark::Open, text("running …"), {}};
    }
    if (!current.result) {
        return {StepMark::Open, facts.poseEdited ? text("moved by hand") : QString(), {}};
    }
    const double ms = current.result->time.totalMs;
    const QString time =
        ms < 1000.0 ? text("%1 ms").arg(ms, 0, 'f', ms < 10.0 ? 1 : 0) : text("%1 s").arg(ms / 1000.0, 0, 'f', 1);
    return {StepMark::Done, time, {}};
}

StepState review(const core::RegistrationCase& current)
{
    if (!current.result) {
        return {};
    }
    if (!current.result->trustworthy) {
        const auto& warnings = current.result->warnings;
        return {StepMark::Look, text("look closely"),
                warnings.empty() ? QString() : QString::fromStdString(warnings.front())};
    }
    return {StepMark::Done, text("%1 mm median").arg(current.result->metrics.medianMm, 0, 'f', 2), {}};
}

}   // namespace

std::array<ui::StepState, ui::stepCount> stepStates(const core::RegistrationCase& current, const StepFacts& facts)
{
    const StepState exported = facts.exported ? StepState{StepMark::Done, text("written"), {}} : StepState{};
    return {vessels(current, facts),      angiogram(current, facts), geometry(current), startPose(current),
            registration(current, facts), review(current),           exported};
}

}   // namespace app
