#include "io/case/stale_results.h"

#include "core/registration/deformable/deformed_tree.h"
#include "io/messages/messages.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace angiopose::io {
namespace {

/// Returns whether a file is unchanged; false for a file without a stored hash.
bool isAsStored(const core::InputFile& stored, const core::InputFile& read)
{
    return stored.path.empty() || (!stored.sha256.empty() && stored.sha256 == read.sha256);
}

bool areAsStored(const core::Vessels& stored, const core::Vessels& read)
{
    return isAsStored(stored.file, read.file) && isAsStored(stored.scanFile, read.scanFile) &&
           stored.excludedBranchIds == read.excludedBranchIds;
}

/// Returns whether a view is unchanged; false for one in another case file, since it was registered with those vessels.
bool isAsStored(const core::View& stored, const core::View& read)
{
    return stored.caseFile.path.empty() && isAsStored(stored.imageFile, read.imageFile) &&
           isAsStored(stored.target.file, read.target.file);
}

/// Returns whether the view's deformation belongs to this tree; one of another tree would be drawn in the wrong place.
bool isOfTree(const core::View& view, const core::Vessels& vessels)
{
    const core::DeformableResult* const deformed = view.result ? view.result->deformed.get() : nullptr;
    return !deformed || !vessels.tree || core::isCompatible(*vessels.tree, *deformed);
}

/// Explains why a view's result is no longer valid; returns nullopt if it is valid.
std::optional<core::Message> staleReason(bool haveInputsChanged, const core::Messages& changedParts)
{
    if (haveInputsChanged) {
        return messages::caseResultStale();
    }
    if (!changedParts.empty()) {
        return messages::caseResultBeside(changedParts);
    }
    return {};
}

/// Returns whether the tracked frames are distinct frames of the view's cine run, and the tracked pose of the view's
/// current frame equals the pose in the case.
bool matchesView(const core::TrackedRun& run, const core::View& view)
{
    const auto& frames = core::framesOf(run);
    const bool areInOrder =
        std::ranges::adjacent_find(frames, std::ranges::greater_equal{}, &core::TrackedRunFrame::frame) == frames.end();
    const bool areThere = !view.angiogram || frames.empty() || frames.back().frame < view.angiogram->frameCount();
    const core::TrackedRunFrame* shown = core::findFrame(run, view.frame);
    return areInOrder && areThere &&
           (!shown || shown->tracked.cameraFromPatient.matrix() == view.cameraFromPatient.matrix());
}

/// Explains why a view's tracking result is no longer valid. Does not consider the view's registration result, which
/// may be absent or belong to another frame.
std::optional<core::Message> staleTrackingReason(bool haveInputsChanged, const ViewNotes& notes, const core::View& view)
{
    auto why = staleReason(haveInputsChanged, notes.changedSinceTracking);
    return why || matchesView(view.followed, view) ? why : messages::caseFollowedMisfit();
}

}   // namespace

void dropStaleResults(const core::Case& stored, std::span<const ViewNotes> notes, core::Case& read,
                      core::Messages& warnings)
{
    const bool areVesselsNoted = areAsStored(stored.vessels, read.vessels);
    for (std::size_t k = 0; k < read.views.size(); ++k) {
        core::View& view = read.views[k];
        const bool areNoted = areVesselsNoted && isAsStored(stored.views[k], view);
        const auto whyResult = staleReason(!areNoted || !isOfTree(view, read.vessels), notes[k].changedSinceResult);
        const auto whyFollowed = staleTrackingReason(!areNoted, notes[k], view);
        const bool isResultGone = whyResult && std::exchange(view.result, std::nullopt);
        const bool isFollowedGone = whyFollowed && std::exchange(view.followed, {}).frames;
        if ((isResultGone || isFollowedGone) && stored.views[k].caseFile.path.empty()) {
            warnings.push_back((isResultGone ? *whyResult : *whyFollowed).about(view.imageFile.path));
        }
    }
}

}   // namespace angiopose::io
