#include "core/registration/vessel_tracker.h"

#include "core/registration/deformable/deformed_tree.h"

#include <utility>

namespace angiopose::core {

namespace {

/// Returns the registration input with the vessels deformed as in the image.
RegistrationInput withDeformedTree(RegistrationInput input, const DeformableResult& deformed)
{
    input.tree = deformedTreeAt(input.tree, deformed, input.initialCameraFromPatient);
    return input;
}

}   // namespace

VesselTracker::VesselTracker(RegistrationInput input, const RegistrationOptions& options, FrameTracker tracker,
                             std::optional<DeformationTracker> deformations)
    : input_(std::move(input)), options_(options), tracker_(std::move(tracker)), deformations_(std::move(deformations))
{
}

Result<VesselTracker> VesselTracker::from(const RegistrationInput& input,
                                          const std::shared_ptr<const DeformableResult>& deformed,
                                          const RegistrationOptions& options)
{
    const RigidTransform& pose = input.initialCameraFromPatient;
    std::optional<DeformationTracker> deformations;
    const bool isDeformed = deformed && isCompatible(input.tree, *deformed);
    if (isDeformed) {
        auto tracker = DeformationTracker::after({input, pose, 0}, *deformed);
        if (!tracker) {
            return tracker.error();
        }
        deformations = std::move(tracker).value();
    }
    auto problem = makeProblem(isDeformed ? withDeformedTree(input, *deformed) : input, options);
    if (!problem) {
        return problem.error();
    }
    return VesselTracker(input, options, FrameTracker(std::move(problem).value(), options), std::move(deformations));
}

Result<TrackedVessels> VesselTracker::next(const Centerline2d& target, const SearchObserver& observe)
{
    const auto tracked = tracker_.next(target, observe);
    if (!tracked) {
        return tracked.error();
    }
    TrackedVessels vessels{tracked.value(), nullptr};
    if (deformations_ && vessels.tracked.isTrustworthy) {   // other frames carry no information about the deformation
        input_.target = target;
        input_.initialCameraFromPatient = vessels.tracked.cameraFromPatient;
        auto found = deformations_->next({input_, vessels.tracked.cameraFromPatient, 0});
        if (found) {
            if (auto deformed = makeProblem(withDeformedTree(input_, found.value()), options_)) {
                tracker_.updateTree(std::move(deformed).value());
            }
            if (found.value().verdict != DeformationVerdict::Rigid) {
                vessels.deformed = std::make_shared<const DeformableResult>(std::move(found).value());
            }
        }
    }
    return vessels;
}

}   // namespace angiopose::core
