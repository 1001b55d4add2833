#include "core/follow_frames.h"

#include "core/messages/says.h"

#include <algorithm>

namespace angiopose::core {
namespace {

Status checkCase(const RegistrationCase& registrationCase)
{
    if (!registrationCase.angiogram || registrationCase.angiogram->frameCount() < 2) {
        return Error(says::followOneFrame());
    }
    if (registrationCase.givenTarget && !registrationCase.editedFrame) {
        return Error(says::followGivenTarget());
    }
    if (!registrationCase.angiogram->gantry.angleIncrementsDeg.empty()) {
        return Error(says::followGantryTurns());
    }
    return Done{};
}

/// Walks away from the first frame in one direction.
class Walk {
public:
    Walk(const RegistrationCase& registrationCase, RegistrationProblem problem)
        : case_(registrationCase),
          tracker_(std::move(problem), registrationCase.options),
          last_(registrationCase.cameraFromPatient)
    {
    }

    FollowedFrame step(int frame)
    {
        FollowedFrame followed;
        followed.frame = frame;
        followed.tracked.cameraFromPatient = last_;
        case_.frame = frame;
        const auto target = targetOf(case_);
        const auto tracked = target ? tracker_.next(target.value()) : Result<TrackedFrame>(target.error());
        if (tracked) {
            followed.tracked = tracked.value();
            last_ = followed.tracked.cameraFromPatient;
        } else {
            followed.problem = tracked.error().message;
        }
        return followed;
    }

private:
    RegistrationCase case_;
    FrameTracker tracker_;
    RigidTransform last_;
};

FollowedFrame givenFrame(const RegistrationCase& registrationCase)
{
    FollowedFrame given;
    given.frame = registrationCase.frame;
    given.tracked.cameraFromPatient = registrationCase.cameraFromPatient;
    given.tracked.isTrustworthy = true;
    given.tracked.score = 1.0;
    return given;
}

}   // namespace

Result<std::vector<FollowedFrame>> followFrames(const RegistrationCase& registrationCase,
                                                const std::function<Verdict(double fraction)>& observe)
{
    if (const Status status = checkCase(registrationCase); !status) {
        return status.error();
    }
    auto target = targetOf(registrationCase);
    if (!target) {
        return target.error();
    }
    const auto input = registrationInputOf(registrationCase, std::move(target).value());
    if (!input) {
        return input.error();
    }
    const auto problem = makeProblem(input.value(), registrationCase.options);
    if (!problem) {
        return problem.error();
    }
    const int count = registrationCase.angiogram->frameCount();
    std::vector<FollowedFrame> frames{givenFrame(registrationCase)};
    bool isStopped = false;
    for (const int direction : {1, -1}) {
        Walk walk(registrationCase, problem.value());
        for (int frame = registrationCase.frame + direction; frame >= 0 && frame < count && !isStopped;
             frame += direction) {
            frames.push_back(walk.step(frame));
            isStopped = observe(static_cast<double>(frames.size()) / count) == Verdict::Stop;
        }
    }
    std::ranges::sort(frames, {}, &FollowedFrame::frame);
    return frames;
}

}   // namespace angiopose::core