#include "core/workflow/track_frames.h"

#include "core/case/known_deformation.h"
#include "core/messages/messages.h"
#include "core/registration/deformable/smooth_deformations.h"
#include "core/registration/vessel_tracker.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace angiopose::core {
namespace {

Status checkCase(const Case& session)
{
    if (!session.shown().angiogram || session.shown().angiogram->frameCount() < 2) {
        return Error(messages::trackingNeedsSeveralFrames());
    }
    if (session.shown().target.centerline && !session.shown().target.editedFrame) {
        return Error(messages::trackingTargetFromFile());
    }
    if (!session.shown().angiogram->gantry.angleIncrementsDeg.empty()) {
        return Error(messages::trackingGantryRotates());
    }
    return Done{};
}

/// Tracks the vessels from the start frame in one direction.
class DirectionTracker {
public:
    DirectionTracker(const Case& session, VesselTracker follower)
        : case_(session), follower_(std::move(follower)), last_(session.shown().cameraFromPatient)
    {
        const auto start = traceCurrentFrame();
        isStartStationary_ = !start || start.value().isStationary;
    }

    TrackedRunFrame step(int frame, const SearchObserver& observe)
    {
        TrackedRunFrame followed;
        followed.frame = frame;
        followed.tracked.cameraFromPatient = last_;
        case_.shown().frame = frame;
        const auto target = currentTarget();
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
    Result<AngiogramTrace> traceCurrentFrame() const
    {
        const View& view = case_.shown();
        return traceFrame(*view.angiogram, view.frame, traceOptionsOf(view));
    }

    /// Returns the target of the current frame. Stationary lines match a pose in every frame, even without contrast
    /// agent, and are not used unless the start frame shows nothing else, as with a phantom.
    Result<Centerline2d> currentTarget() const
    {
        if (const auto given = givenTargetOf(case_.shown())) {
            return *given;
        }
        const auto trace = traceCurrentFrame();
        if (!trace) {
            return trace.error();
        }
        return trace.value().isStationary && !isStartStationary_
                   ? Result<Centerline2d>(Error(messages::trackingOnlyStationaryLines()))
                   : trace.value().centerline;
    }

    Case case_;
    VesselTracker follower_;
    RigidTransform last_;
    bool isStartStationary_ = false;
};

/// Returns the deformation to continue, if it was found in a single view; a single run does not determine how a 3-D
/// deformation found in several views continues.
std::shared_ptr<const DeformableResult> deformationToTrack(const Case& session)
{
    const auto deformed = knownDeformation(session.shown(), session.vessels, session.shown().cameraFromPatient);
    return deformed && deformed->viewPoses.size() == 1 ? deformed : nullptr;
}

TrackedRunFrame initialTrackedFrame(const Case& session)
{
    TrackedRunFrame given;
    given.frame = session.shown().frame;
    given.tracked.cameraFromPatient = session.shown().cameraFromPatient;
    given.tracked.isTrustworthy = true;
    given.tracked.score = 1.0;
    given.deformed = deformationToTrack(session);
    return given;
}

/// Smooths the deformations, which were found frame by frame, over time.
void smoothDeformations(const VesselTree& tree, std::vector<TrackedRunFrame>& frames)
{
    std::vector<TimedDeformation> deformations;
    for (const TrackedRunFrame& each : frames) {
        if (each.deformed) {
            deformations.push_back({each.frame, each.tracked.cameraFromPatient, each.deformed});
        }
    }
    for (const TimedDeformation& smooth : smoothOverTime(tree, deformations)) {
        std::ranges::find(frames, smooth.frame, &TrackedRunFrame::frame)->deformed = smooth.deformed;
    }
}

/// Gives unreliable frames without a deformation the deformation of the nearest frame that has one, because their poses
/// are those of deformed vessels.
void fillMissingDeformations(std::vector<TrackedRunFrame>& frames)
{
    const std::vector<TrackedRunFrame> found = frames;
    for (TrackedRunFrame& each : frames) {
        const TrackedRunFrame* nearest = nullptr;
        for (const TrackedRunFrame& other : found) {
            if (other.deformed &&
                (!nearest || std::abs(other.frame - each.frame) < std::abs(nearest->frame - each.frame))) {
                nearest = &other;
            }
        }
        if (each.deformed || !nearest || each.tracked.isTrustworthy) {
            continue;
        }
        each.deformed = transferDeformation(*nearest, each.tracked.cameraFromPatient);
        each.deformationSourceFrame = nearest->frame;
    }
}

}   // namespace

Result<std::vector<TrackedRunFrame>> trackFrames(const Case& session, const WorkObserver& observe)
{
    if (const Status status = checkCase(session); !status) {
        return status.error();
    }
    auto target = targetOf(session.shown());
    if (!target) {
        return target.error();
    }
    const auto input = makeRegistrationInput(session.shown(), session.vessels, std::move(target).value());
    if (!input) {
        return input.error();
    }
    const auto follower = VesselTracker::from(input.value(), deformationToTrack(session), session.options);
    if (!follower) {
        return follower.error();
    }
    const int count = session.shown().angiogram->frameCount();
    std::vector<TrackedRunFrame> frames{initialTrackedFrame(session)};
    ProgressReporter progress(observe);
    progress.enter(0.0, 1.0, session.shownView);
    for (const int direction : {1, -1}) {
        DirectionTracker tracker(session, follower.value());
        for (int frame = session.shown().frame + direction; frame >= 0 && frame < count && !progress.isStopped();
             frame += direction) {
            const double done = static_cast<double>(frames.size()) / count;
            TrackedRunFrame followed = tracker.step(frame, [&](double) { return progress.report("following", done); });
            if (progress.isStopped()) {
                break;   // tracking was stopped during this frame
            }
            frames.push_back(std::move(followed));
            progress.report("following", static_cast<double>(frames.size()) / count);
        }
    }
    std::ranges::sort(frames, {}, &TrackedRunFrame::frame);
    if (session.vessels.tree) {
        smoothDeformations(*session.vessels.tree, frames);
        fillMissingDeformations(frames);
    }
    return frames;
}

RunPeriods periodsOf(const Case& session, const std::vector<TrackedRunFrame>& frames)
{
    const auto& run = session.shown().angiogram;
    if (!run || !session.vessels.tree || !(run->frameTimeMs > 1.0)) {   // 1 ms or less: not specified
        return {};
    }
    std::vector<TimedPose> poses;
    for (const TrackedRunFrame& each : frames) {
        if (each.tracked.isTrustworthy) {
            poses.push_back({1e-3 * run->frameTimeMs * each.frame, each.tracked.cameraFromPatient});
        }
    }
    return findPeriods(poses, centroidInPatient(*session.vessels.tree));
}

}   // namespace angiopose::core
