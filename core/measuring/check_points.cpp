#include "core/measuring/check_points.h"

#include "core/case/known_bend.h"
#include "core/messages/says.h"
#include "core/registration/deformable/bent_tree.h"

#include <algorithm>

namespace angiopose::core {
namespace {

/// The place in the frame of the pose, else the first that there is.
const Sighting* sightingOf(const View& view, int markId)
{
    const Sighting* found = nullptr;
    for (const Sighting& each : view.sightings) {
        if (each.markId == markId && (!found || each.frame == view.frame)) {
            found = &each;
        }
    }
    return found;
}

std::optional<double> errorBent(const View& view, const Vessels& vessels, const Sight& sight, const VesselMark& mark,
                                const Sighting& seen)
{
    const auto bend = knownBend(view, vessels, sight.cameraFromPatient);
    if (!bend) {
        return std::nullopt;
    }
    const VesselTree bent = bentTreeAt(*vessels.tree, *bend, sight.cameraFromPatient);
    const auto error = imageError(sight, movedWith(*vessels.tree, bent, mark).pointInPatient, seen.pixel);
    return error ? std::optional(error.value().mm) : std::nullopt;
}

CheckedView checkedView(const View& view, const Vessels& vessels, const RigidTransform& pose, const VesselMark& mark,
                        const Sighting& seen)
{
    CheckedView checked{0, seen.frame, Error(says::checkNotSeen()), {}, {}};
    const auto camera = cameraOf(view);
    if (!camera) {
        checked.error = camera.error();
        return checked;
    }
    if (seen.frame != view.frame) {
        checked.error = Error(says::checkOtherFrame(seen.frame + 1, view.frame + 1));
        return checked;
    }
    const Sight sight{camera.value(), pose};
    checked.error = imageError(sight, mark.pointInPatient, seen.pixel);
    checked.bentMm = errorBent(view, vessels, sight, mark, seen);
    const bool isFound = view.result && view.result->cameraFromPatient.matrix() == pose.matrix();
    if (isFound && vessels.tree) {
        checked.claimed = claimedError(*view.result, *vessels.tree, camera.value(), mark.pointInPatient);
    }
    return checked;
}

std::string listed(const std::vector<std::size_t>& views)
{
    std::string text;
    for (const std::size_t view : views) {
        text += (text.empty() ? "" : ", ") + std::to_string(view + 1);
    }
    return text;
}

CheckedPoint checkedPoint(const Case& theCase, const VesselMark& mark, const PoseOfView& poseOf)
{
    CheckedPoint checked{mark, {}, Error(says::checkNeedsTwoViews()), {}, {}};
    std::vector<PointedPixel> rays;
    for (std::size_t place = 0; place < theCase.views.size(); ++place) {
        const View& view = theCase.views[place];
        const Sighting* seen = view.angiogram ? sightingOf(view, mark.id) : nullptr;
        if (!seen) {
            continue;
        }
        const RigidTransform pose = poseOf(place);
        CheckedView& told = checked.views.emplace_back(checkedView(view, theCase.vessels, pose, mark, *seen));
        told.view = place;
        if (!told.error) {
            continue;
        }
        rays.push_back({{cameraOf(view).value(), pose}, seen->pixel});
        checked.meetingViews.push_back(place);
        if (told.claimed) {
            const double claimed = told.claimed->spaceMm;
            checked.claimedSpaceMm = std::min(claimed, checked.claimedSpaceMm.value_or(claimed));
        }
    }
    checked.meeting = meetingPoint(rays);
    return checked;
}

Message offBy(double mm, const std::optional<double>& claimedMm)
{
    const Quantity off = inMm(mm, 1);
    return claimedMm ? says::checkLabelClaimed(off, inMm(*claimedMm, 1)) : says::checkLabel(off);
}

}   // namespace

std::vector<CheckedPoint> checkedPoints(const Case& theCase, const PoseOfView& poseOf)
{
    std::vector<CheckedPoint> checked;
    for (const VesselMark& mark : theCase.vessels.marks) {
        if (mark.kind == VesselMarkKind::CheckPoint) {
            checked.push_back(checkedPoint(theCase, mark, poseOf));
        }
    }
    return checked;
}

std::vector<CheckedPoint> checkedPoints(const Case& theCase)
{
    return checkedPoints(theCase, [&theCase](std::size_t view) { return theCase.views[view].cameraFromPatient; });
}

std::optional<Message> labelOf(const CheckedPoint& checked, std::size_t shownView)
{
    const auto shown = std::ranges::find(checked.views, shownView, &CheckedView::view);
    if (shown != checked.views.end() && shown->error) {
        const std::optional<double> claimed = shown->claimed ? std::optional(shown->claimed->inPlaneMm) : std::nullopt;
        return offBy(shown->error.value().mm, claimed);
    }
    return checked.meeting ? std::optional(offBy(checked.spaceMm(), checked.claimedSpaceMm)) : std::nullopt;
}

Messages sentencesOf(const CheckedView& checked)
{
    if (!checked.error) {
        return {checked.error.error().message};
    }
    const ImageError& error = checked.error.value();
    Messages sentences{
        says::checkImageError(inMm(error.depthMm, 0), inMm(error.mm, 2), Quantity{error.px, 1, "px"},
                              inMm(error.mmPerPx, 2)),
        checked.claimed ? says::checkClaimed(inMm(checked.claimed->inPlaneMm, 2)) : says::checkNothingClaimed()};
    if (checked.bentMm) {
        sentences.push_back(says::checkBent(inMm(*checked.bentMm, 2)));
    }
    return sentences;
}

Messages spaceSentences(const CheckedPoint& checked)
{
    if (checked.views.empty()) {
        return {says::checkNotSeen()};
    }
    if (!checked.meeting) {
        return {checked.meeting.error().message};
    }
    const MeetingPoint& meeting = checked.meeting.value();
    Messages sentences{says::checkSpaceError(listed(checked.meetingViews), Quantity{meeting.angleDeg, 0, "°"},
                                             inMm(checked.spaceMm(), 2), inMm(meeting.raysApartMm, 2))};
    if (checked.claimedSpaceMm) {
        sentences.push_back(says::checkClaimed(inMm(*checked.claimedSpaceMm, 2)));
    }
    return sentences;
}

}   // namespace angiopose::core
