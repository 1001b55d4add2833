#pragma once

#include "core/registration/registration.h"

#include <cstddef>
#include <span>
#include <vector>

namespace angiopose::core {

/// How well the step from the first view to another is known, 1-σ per axis (ALGORITHMS §5.5). As it stands: of planes
/// that were taken together, whose headers are rounded and whose gantries sag.
struct StepSpread {
    double rotationDeg = 0.5;
    Eigen::Vector3d shiftMm = Eigen::Vector3d::Constant(1.5);   ///< of the tree's centroid, in that view's camera axes

    /// Whether a pose in one view says where about the vessels lie in the other.
    bool knowsShift() const { return shiftMm.maxCoeff() < 20.0; }
};

struct MultiViewOptions {
    std::vector<StepSpread> steps{};   ///< to each view; the first's does not matter. Empty: taken together
    std::vector<std::size_t> numbers{};   ///< what the views are called in messages; empty: 1, 2, … in the order given

    StepSpread stepTo(std::size_t index) const { return index < steps.size() ? steps[index] : StepSpread(); }
    std::size_t numberOf(std::size_t index) const { return index < numbers.size() ? numbers[index] : index + 1; }
};

/// One rigid tree in several views.
struct MultiViewResult {
    std::vector<RegistrationResult> views;   ///< each judged at its joint pose, in the order given
    /// How far each view's geometry turned out to be from its header, relative to the first view: turn about the
    /// tree's centroid (rad) and shift (mm) in that view's camera axes. Zero for the first.
    std::vector<Vector6d> corrections;
    PoseUncertainty uncertainty;   ///< of the first view's pose, from all views
    std::vector<CameraEvidence> cameras;   ///< from all views, one for each; empty: all cameras count as exact
    std::shared_ptr<const DeformableResult> deformed;   ///< see RegistrationResult
    bool trustworthy = false;   ///< every view is, and no correction is implausible
    Messages warnings;
};

/// Registers one tree to two or more views of the same moment (bi-plane), or to frames between which the gantry turned
/// (ALGORITHMS §6.12). The start poses tell the geometry: startOfB ∘ startOfA⁻¹ leads from camera to camera, up to the
/// small corrections that `multiView` allows. One view's depth is another's shift, so the depth becomes as certain as
/// the shift. Reports tell whose pose they show; iterations and progress count all views. A stop keeps the best pose so
/// far. Fails like registerVessels, naming the view, and when the views show different trees.
Result<MultiViewResult> registerViews(std::span<const RegistrationInput> inputs,
                                      const RegistrationOptions& options = {}, const MultiViewOptions& multiView = {},
                                      const IterationObserver& observe = {});

}   // namespace angiopose::core