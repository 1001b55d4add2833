#pragma once

#include "core/registration/registration.h"

#include <cstddef>
#include <span>
#include <vector>

namespace angiopose::core {

/// 1-σ uncertainty per axis of the transform from the first view to another (ALGORITHMS §5.5). The defaults apply to
/// simultaneously acquired planes and cover rounded header values and gantry sag.
struct RelativePoseStd {
    double rotationDeg = 0.5;
    Eigen::Vector3d shiftMm =
        Eigen::Vector3d::Constant(1.5);   ///< shift of the tree's centroid, in that view's camera axes

    /// Whether a pose in one view predicts the approximate position of the vessels in the other.
    bool predictsPosition() const { return shiftMm.maxCoeff() < 20.0; }
};

struct MultiViewOptions {
    std::vector<RelativePoseStd> steps{};   ///< one per view, the first unused; empty for simultaneous acquisition
    std::vector<std::size_t> numbers{};   ///< view numbers for messages; empty for 1, 2, … in the given order

    RelativePoseStd relativePoseStd(std::size_t index) const
    {
        return index < steps.size() ? steps[index] : RelativePoseStd();
    }
    std::size_t viewNumber(std::size_t index) const { return index < numbers.size() ? numbers[index] : index + 1; }
};

/// Result of registering one rigid tree to several views.
struct MultiViewResult {
    std::vector<RegistrationResult> views;   ///< results at the joint pose, in the given order of the views
    /// Estimated correction of each view's geometry relative to its header and to the first view: rotation about the
    /// tree's centroid (rad) and shift (mm) in the camera axes of that view. Zero for the first view.
    std::vector<Vector6d> corrections;
    PoseUncertainty uncertainty;   ///< uncertainty of the first view's pose, from all views
    std::vector<CameraEvidence> cameras;   ///< one per view, from all views; empty if all cameras are treated as exact
    std::shared_ptr<const DeformableResult> deformed;   ///< see RegistrationResult
    bool trustworthy = false;   ///< whether all views are reliable and all corrections plausible
    Messages warnings;
};

/// Registers one tree to two or more simultaneous views (biplane), or to frames between which the gantry rotated
/// (ALGORITHMS §6.12). The initial poses of the views define the relative geometry, up to the small corrections that
/// `multiView` allows. The depth in one view is a lateral shift in another, which makes it equally certain. Each report
/// names the view of its pose; iterations and progress count all views. If the user stops, the best pose so far is
/// kept. Fails like registerVessels, naming the view, and also if the views use different trees.
Result<MultiViewResult> registerViews(std::span<const RegistrationInput> inputs,
                                      const RegistrationOptions& options = {}, const MultiViewOptions& multiView = {},
                                      const IterationObserver& observe = {});

}   // namespace angiopose::core
