#include "core/workflow/follow_frames.h"

#include "core/case/known_deformation.h"
#include "core/messages/messages.h"
#include "core/registration/deformable/smooth_deformations.h"
#include "core/registration/follow_run.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace angiopose::core {
namespace {

Status checkCase(const Case& session)
{
    if (!session.shown().angiogram || session.shown().angiogram->frameCount() < 2) {
        return Error(messages::followOneFrame());
    }
    if (session.shown().target.centerline && !session.shown().target.editedFrame) {
        return Error(messages::followGivenTarget());
    }
    if (!session.shown().angiogram->gantry.angleIncrementsDeg.empty()) {
        return Error(messages::followGantryTurns());
    }
    return Done{};
}

/// Tracks the vessels from the start frame in one direction.
class Walk {
public:
    Walk(const Case& session, RunFollower follower)
        : case_(session), follower_(std::move(follower)), last_(session.shown().cameraFromPatient)
    {
        const auto start = traceHere();
        startsStill_ = !start || start.value().standsStill;
    }

    FollowedFrame step(int frame, const SearchObserver& observe)
    {
        FollowedFrame followed;
        followed.frame = frame;
        followed.tracked.cameraFromPatient = last_;
        case_.shown().frame = frame;
        const auto target = targetHere();
        const auto found = target ? follower_.next(target.value(), observe) : Result<TrackedVessels>(target.error());
        if (found) {
            followed.tracked = found.value().tracked;
            followed.deformed = found.value().deformed;
            last_ = followed.tracked.cameraFromPatient;
        } else {
            followed.problem = found.error().message;
        }
        return followed;
    }

private:
    Result<AngiogramTrace> traceHere() const
    {
        const View& view = case_.shown();
        return traceFrame(*view.angiogram, view.frame, traceOptionsOf(view));
    }

    /// Returns the target of the current frame. Stationary lines match a pose in every frame, even without contrast,
    /// and are not used, unless the start frame shows nothing else, as with a phantom.
    Result<Centerline2d> targetHere() const
    {
        if (const auto given = givenTargetOf(case_.shown())) {
            return *given;
        }
        const auto trace = traceHere();
        if (!trace) {
            return trace.error();
        }
        return trace.value().standsStill && !startsStill_ ? Result<Centerline2d>(Error(messages::followStandsStill()))
                                                          : trace.value().centerline;
    }

    Case case_;
    RunFollower follower_;
    RigidTransform last_;
    bool startsStill_ = false;
};

/// Returns the deformation to continue, if it was found in a single view; a single run does not determine how a 3-D
/// deformation found in several views continues.
std::shared_ptr<const DeformableResult> deformationToFollow(const Case& session)
{
    const auto deformed = knownDeformation(session.shown(), session.vessels, session.shown().cameraFromPatient);
    return deformed && deformed->viewPoses.size() == 1 ? deformed : nullptr;
}

FollowedFrame givenFrame(const Case& session)
{
    FollowedFrame given;
    given.frame = session.shown().frame;
    given.tracked.cameraFromPatient = session.shown().cameraFromPatient;
    given.tracked.isTrustworthy = true;
    given.tracked.score = 1.0;
    given.deformed = deformationToFollow(session);
    return given;
}

/// Smooths the deformations, which were found frame by frame, over time.
void smoothBends(const VesselTree& tree, std::vector<FollowedFrame>& frames)
{
    std::vector<DeformationInTime> deformations;
    for (const FollowedFrame& each : frames) {
        if (each.deformed) {
            deformations.push_back({each.frame, each.tracked.cameraFromPatient, each.deformed});
        }
    }
    for (const DeformationInTime& smooth : smoothInTime(tree, deformations)) {
        std::ranges::find(frames, smooth.frame, &FollowedFrame::frame)->deformed = smooth.deformed;
    }
}

/// Gives unreliable frames without a deformation the deformation of the nearest frame that has one, because their poses
/// are those of deformed vessels.
void carryDeformation(std::vector<FollowedFrame>& frames)
{
    const std::vector<FollowedFrame> found = frames;
    for (FollowedFrame& each : frames) {
        const FollowedFrame* nearest = nullptr;
        for (const FollowedFrame& other : found) {
            if (other.deformed &&
                (!nearest || std::abs(other.frame - each.frame) < std::abs(nearest->frame - each.frame))) {
                nearest = &other;
            }
        }
        if (each.deformed || !nearest || each.tracked.isTrustworthy) {
            continue;
        }
        each.deformed = carriedDeformation(*nearest, each.tracked.cameraFromPatient);
        each.deformedAsInFrame = nearest->frame;
    }
}

}   // namespace

Result<std::vector<FollowedFrame>> followFrames(const Case& session, const WorkObserver& observe)
{
    if (const Status status = checkCase(session); !status) {
        return status.error();
    }
    auto target = targetOf(session.shown());
    if (!target) {
        return target.error();
    }
    const auto input = registrationInputOf(session.shown(), session.vessels, std::move(target).value());
    if (!input) {
        return input.error();
    }
    const auto follower = RunFollower::from(input.value(), deformationToFollow(session), session.options);
    if (!follower) {
        return follower.error();
    }
    const int count = session.shown().angiogram->frameCount();
    std::vector<FollowedFrame> frames{givenFrame(session)};
    Course course(observe);
    course.enter(0.0, 1.0, session.shownView);
    for (const int direction : {1, -1}) {
        Walk walk(session, follower.value());
        for (int frame = session.shown().frame + direction; frame >= 0 && frame < count && !course.isStopped();
             frame += direction) {
            const double done = static_cast<double>(frames.size()) / count;
            FollowedFrame followed = walk.step(frame, [&](double) { return course.tell("following", done); });
            if (course.isStopped()) {
                break;   // tracking was stopped during this frame
            }
            frames.push_back(std::move(followed));
            course.tell("following", static_cast<double>(frames.size()) / count);
        }
    }
    std::ranges::sort(frames, {}, &FollowedFrame::frame);
    if (session.vessels.tree) {
        smoothBends(*session.vessels.tree, frames);
        carryDeformation(frames);
    }
    return frames;
}

RunPeriods periodsOf(const Case& session, const std::vector<FollowedFrame>& frames)
{
    const auto& run = session.shown().angiogram;
    if (!run || !session.vessels.tree || !(run->frameTimeMs > 1.0)) {   // 1 ms or less: not specified
        return {};
    }
    std::vector<TimedPose> poses;
    for (const FollowedFrame& each : frames) {
        if (each.tracked.isTrustworthy) {
            poses.push_back({1e-3 * run->frameTimeMs * each.frame, each.tracked.cameraFromPatient});
        }
    }
    return findPeriods(poses, centroidInPatient(*session.vessels.tree));
}

}   // namespace angiopose::core
