#pragma once

#include "core/registration/registration.h"

#include <cstddef>
#include <span>
#include <vector>

namespace angiopose::core {

/// Uncertainty of the step from the first view to another, 1-σ per axis (ALGORITHMS §5.5). The defaults apply to
/// simultaneously acquired planes with rounded header values and gantry sag.
struct StepSpread {
    double rotationDeg = 0.5;
    Eigen::Vector3d shiftMm =
        Eigen::Vector3d::Constant(1.5);   ///< shift of the tree's centroid, in that view's camera axes

    /// Whether a pose in one view gives the approximate position of the vessels in the other.
    bool knowsShift() const { return shiftMm.maxCoeff() < 20.0; }
};

struct MultiViewOptions {
    std::vector<StepSpread> steps{};   ///< one per view; that of the first is unused. Empty: simultaneous acquisition
    std::vector<std::size_t> numbers{};   ///< view numbers shown in messages; empty: 1, 2, … in the order given

    StepSpread stepTo(std::size_t index) const { return index < steps.size() ? steps[index] : StepSpread(); }
    std::size_t numberOf(std::size_t index) const { return index < numbers.size() ? numbers[index] : index + 1; }
};

/// Result for one rigid tree in several views.
struct MultiViewResult {
    std::vector<RegistrationResult> views;   ///< each judged at its joint pose, in the order given
    /// Corrections of each view's geometry found relative to its header and to the first view: rotation about the
    /// tree's centroid (rad) and shift (mm) in that view's camera axes. Zero for the first.
    std::vector<Vector6d> corrections;
    PoseUncertainty uncertainty;   ///< of the first view's pose, from all views
    std::vector<CameraEvidence> cameras;   ///< one per view, from all views; empty: all cameras count as exact
    std::shared_ptr<const DeformableResult> deformed;   ///< see RegistrationResult
    bool trustworthy = false;   ///< all views are reliable and no correction is implausible
    Messages warnings;
};

/// Registers one tree to two or more simultaneous views (biplane), or to frames between which the gantry rotated
/// (ALGORITHMS §6.12). The initial poses define the geometry: startOfB ∘ startOfA⁻¹ leads from camera to camera, up to
/// the small corrections that `multiView` allows. The depth in one view is a lateral shift in another and thus becomes
/// as certain as the shift. Reports contain the view of their pose; iterations and progress count all views. A stop
/// keeps the best pose so far. Fails like registerVessels, naming the view, and if the views show different trees.
Result<MultiViewResult> registerViews(std::span<const RegistrationInput> inputs,
                                      const RegistrationOptions& options = {}, const MultiViewOptions& multiView = {},
                                      const IterationObserver& observe = {});

}   // namespace angiopose::core