#include "core/workflow/follow_frames.h"

#include "core/messages/says.h"

#include <algorithm>

namespace angiopose::core {
namespace {

Status checkCase(const Case& theCase)
{
    if (!theCase.shown().angiogram || theCase.shown().angiogram->frameCount() < 2) {
        return Error(says::followOneFrame());
    }
    if (theCase.shown().target.centerline && !theCase.shown().target.editedFrame) {
        return Error(says::followGivenTarget());
    }
    if (!theCase.shown().angiogram->gantry.angleIncrementsDeg.empty()) {
        return Error(says::followGantryTurns());
    }
    return Done{};
}

/// Walks away from the first frame in one direction.
class Walk {
public:
    Walk(const Case& theCase, RegistrationProblem problem)
        : case_(theCase), tracker_(std::move(problem), theCase.options), last_(theCase.shown().cameraFromPatient)
    {
    }

    FollowedFrame step(int frame, const SearchObserver& observe)
    {
        FollowedFrame followed;
        followed.frame = frame;
        followed.tracked.cameraFromPatient = last_;
        case_.shown().frame = frame;
        const auto target = targetOf(case_.shown());
        const auto tracked = target ? tracker_.next(target.value(), observe) : Result<TrackedFrame>(target.error());
        if (tracked) {
            followed.tracked = tracked.value();
            last_ = followed.tracked.cameraFromPatient;
        } else {
            followed.problem = tracked.error().message;
        }
        return followed;
    }

private:
    Case case_;
    FrameTracker tracker_;
    RigidTransform last_;
};

FollowedFrame givenFrame(const Case& theCase)
{
    FollowedFrame given;
    given.frame = theCase.shown().frame;
    given.tracked.cameraFromPatient = theCase.shown().cameraFromPatient;
    given.tracked.isTrustworthy = true;
    given.tracked.score = 1.0;
    return given;
}

}   // namespace

Result<std::vector<FollowedFrame>> followFrames(const Case& theCase, const WorkObserver& observe)
{
    if (const Status status = checkCase(theCase); !status) {
        return status.error();
    }
    auto target = targetOf(theCase.shown());
    if (!target) {
        return target.error();
    }
    const auto input = registrationInputOf(theCase.shown(), theCase.vessels, std::move(target).value());
    if (!input) {
        return input.error();
    }
    const auto problem = makeProblem(input.value(), theCase.options);
    if (!problem) {
        return problem.error();
    }
    const int count = theCase.shown().angiogram->frameCount();
    std::vector<FollowedFrame> frames{givenFrame(theCase)};
    Course course(observe);
    course.enter(0.0, 1.0, theCase.shownView);
    for (const int direction : {1, -1}) {
        Walk walk(theCase, problem.value());
        for (int frame = theCase.shown().frame + direction; frame >= 0 && frame < count && !course.isStopped();
             frame += direction) {
            const double done = static_cast<double>(frames.size()) / count;
            FollowedFrame followed = walk.step(frame, [&](double) { return course.tell("following", done); });
            if (course.isStopped()) {
                break;   // in the midst of this frame
            }
            frames.push_back(std::move(followed));
            course.tell("following", static_cast<double>(frames.size()) / count);
        }
    }
    std::ranges::sort(frames, {}, &FollowedFrame::frame);
    return frames;
}

}   // namespace angiopose::core