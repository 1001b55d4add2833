#include "core/registration/follow_run.h"

#include "core/registration/deformable/bent_tree.h"

#include <utility>

namespace angiopose::core {

namespace {

/// The question with the vessels as they lie in the image.
RegistrationInput asBent(RegistrationInput input, const DeformableResult& bent)
{
    input.tree = bentTreeAt(input.tree, bent, input.initialCameraFromPatient);
    return input;
}

}   // namespace

RunFollower::RunFollower(RegistrationInput input, const RegistrationOptions& options, FrameTracker tracker,
                         std::optional<BendTracker> bends)
    : input_(std::move(input)), options_(options), tracker_(std::move(tracker)), bends_(std::move(bends))
{
}

Result<RunFollower> RunFollower::from(const RegistrationInput& input,
                                      const std::shared_ptr<const DeformableResult>& bent,
                                      const RegistrationOptions& options)
{
    const RigidTransform& pose = input.initialCameraFromPatient;
    std::optional<BendTracker> bends;
    const bool isBent = bent && isOf(input.tree, *bent);
    if (isBent) {
        auto tracker = BendTracker::after({input, pose, 0}, *bent);
        if (!tracker) {
            return tracker.error();
        }
        bends = std::move(tracker).value();
    }
    auto problem = makeProblem(isBent ? asBent(input, *bent) : input, options);
    if (!problem) {
        return problem.error();
    }
    return RunFollower(input, options, FrameTracker(std::move(problem).value(), options), std::move(bends));
}

Result<TrackedVessels> RunFollower::next(const Centerline2d& target, const SearchObserver& observe)
{
    const auto tracked = tracker_.next(target, observe);
    if (!tracked) {
        return tracked.error();
    }
    TrackedVessels followed{tracked.value(), nullptr};
    if (bends_ && followed.tracked.isTrustworthy) {   // other frames tell nothing of their bend
        input_.target = target;
        input_.initialCameraFromPatient = followed.tracked.cameraFromPatient;
        auto found = bends_->next({input_, followed.tracked.cameraFromPatient, 0});
        if (found) {
            if (auto bent = makeProblem(asBent(input_, found.value()), options_)) {
                tracker_.followAsBent(std::move(bent).value());
            }
            if (found.value().verdict != BendVerdict::Rigid) {
                followed.bent = std::make_shared<const DeformableResult>(std::move(found).value());
            }
        }
    }
    return followed;
}

}   // namespace angiopose::core
