#include "app/texts/word_of_run.h"

#include "app/messages/messages.h"

#include <algorithm>

namespace angiopose::app {
namespace {

void takeOver(core::RegistrationResult& judged, const core::RegistrationResult& run)
{
    judged.method = run.method;
    judged.warnings = run.warnings;
    judged.trustworthy = run.trustworthy;
    judged.probabilityWithin2Mm = run.probabilityWithin2Mm;
    judged.uncertainty = run.uncertainty;
    judged.stopReason = run.stopReason;
    judged.time = run.time;
    if (!run.unopacified.empty() ||
        !run.wirePaths.empty()) {   // such metrics refer only to the part of the tree that the image shows
        judged.unopacified = run.unopacified;
        judged.wirePaths = run.wirePaths;
        judged.metrics = run.metrics;
        judged.branches = run.branches;
    }
}

/// Returns the snapshot of the newest registration that ended at exactly this pose, or null.
const core::PoseSnapshot* runThatLeft(const core::View& view)
{
    const auto isOfRun = [&view](const core::PoseSnapshot& snapshot) {
        return !snapshot.method.empty() && snapshot.cameraFromPatient.matrix() == view.cameraFromPatient.matrix();
    };
    const auto found = std::ranges::find_if(view.snapshots.rbegin(), view.snapshots.rend(), isOfRun);
    return found == view.snapshots.rend() ? nullptr : &*found;
}

}   // namespace

FoundBy takeWordOfRun(core::RegistrationResult& judged, const core::View& view)
{
    if (const core::RegistrationResult* const run = core::resultOfShownFrame(view)) {
        takeOver(judged, *run);
        return FoundBy::ItsRun;
    }
    const core::PoseSnapshot* const left = runThatLeft(view);
    if (!left && !view.result) {
        return FoundBy::NoRun;
    }
    const bool isDistrusted =
        (view.result && !view.result->trustworthy) || (left && left->metrics && !left->metrics->isTrustworthy);
    if (isDistrusted) {
        judged.trustworthy = false;
        judged.warnings.push_back(messages::runDistrusted());
    }
    return FoundBy::AnEarlierRun;
}

}   // namespace angiopose::app
