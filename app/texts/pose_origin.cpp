#include "app/texts/pose_origin.h"

#include "app/messages/messages.h"

#include <algorithm>

namespace angiopose::app {
namespace {

void takeOver(core::RegistrationResult& evaluated, const core::RegistrationResult& run)
{
    evaluated.method = run.method;
    evaluated.warnings = run.warnings;
    evaluated.trustworthy = run.trustworthy;
    evaluated.probabilityWithin2Mm = run.probabilityWithin2Mm;
    evaluated.uncertainty = run.uncertainty;
    evaluated.stopReason = run.stopReason;
    evaluated.time = run.time;
    if (!run.unopacified.empty() ||
        !run.wirePaths.empty()) {   // these metrics refer only to the part of the tree that the image shows
        evaluated.unopacified = run.unopacified;
        evaluated.wirePaths = run.wirePaths;
        evaluated.metrics = run.metrics;
        evaluated.branches = run.branches;
    }
}

/// Returns the snapshot of the newest registration that ended at exactly this pose; null if there is none.
const core::PoseSnapshot* snapshotOfRegistration(const core::View& view)
{
    const auto isOfRun = [&view](const core::PoseSnapshot& snapshot) {
        return !snapshot.method.empty() && snapshot.cameraFromPatient.matrix() == view.cameraFromPatient.matrix();
    };
    const auto found = std::ranges::find_if(view.snapshots.rbegin(), view.snapshots.rend(), isOfRun);
    return found == view.snapshots.rend() ? nullptr : &*found;
}

}   // namespace

PoseOrigin addRegistrationResult(core::RegistrationResult& evaluated, const core::View& view)
{
    if (const core::RegistrationResult* const run = core::resultOfShownFrame(view)) {
        takeOver(evaluated, *run);
        return PoseOrigin::Registration;
    }
    const core::PoseSnapshot* const left = snapshotOfRegistration(view);
    if (!left && !view.result) {
        return PoseOrigin::None;
    }
    const bool isDistrusted =
        (view.result && !view.result->trustworthy) || (left && left->metrics && !left->metrics->isTrustworthy);
    if (isDistrusted) {
        evaluated.trustworthy = false;
        evaluated.warnings.push_back(messages::runDistrusted());
    }
    return PoseOrigin::EarlierRegistration;
}

}   // namespace angiopose::app
