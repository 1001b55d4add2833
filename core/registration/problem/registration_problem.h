#pragma once

#include "core/registration/pose/pose_freedom.h"
#include "core/registration/problem/registration_result.h"

#include <cstdint>

namespace angiopose::core {

/// Tree in the form used by the methods: evenly spaced points of all used branches, concatenated.
struct TreeSamples {
    std::vector<Eigen::Vector3d> points;   ///< patient LPS mm
    std::vector<Eigen::Vector3d> tangents;   ///< unit vectors
    std::vector<double> radiusMm;   ///< vessel radius; 0 if unknown
    std::vector<int> branchIndex;   ///< index into branchIds, ascending
    std::vector<std::uint8_t> isNode;   ///< 1 if the point represents a bifurcation or an end
    std::vector<int> branchIds;   ///< ids of the used branches, in the tree's order
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();   ///< mean of the points; rotation center used by methods
    double spreadMm = 1.0;   ///< RMS distance ρ of the points from their centroid

    std::size_t size() const { return points.size(); }
    bool hasRadius() const;
};

/// Traced vessels in the form used by the methods: evenly spaced points of all curves, concatenated.
struct TargetSamples {
    std::vector<Eigen::Vector2d> points;   ///< px
    std::vector<Eigen::Vector2d> tangents;   ///< unit vectors
    std::vector<double> radiusPx;   ///< vessel radius; 0 if unknown
    std::vector<int> curveIndex;   ///< ascending

    std::size_t size() const { return points.size(); }
};

/// Validated and resampled registration input; the common starting point of all methods.
struct RegistrationProblem {
    ProjectionCamera camera;
    CameraUncertainty cameraUncertainty{};   ///< standard deviations of the camera errors selected by the options
    RigidTransform start;   ///< initial cameraFromPatient, exactly rigid
    TreeSamples tree;   ///< samples without the excluded branches
    Eigen::Vector3d wholeTreeCentroid =
        Eigen::Vector3d::Zero();   ///< length-weighted centroid including excluded branches, as shown to users
    PoseFreedom freedom;   ///< defined by the locks in the options
    TargetSamples target;
    std::vector<int> auxiliary;   ///< indices of the tree points {p'}, selected by option `auxiliary`
    bool hasUserAuxiliary = false;   ///< whether the user selected branches for {p'}
    std::shared_ptr<const ImageF> image;   ///< input image in the camera's size, or null
    Polarity polarity = Polarity::VesselsDark;
    std::shared_ptr<const Mask2d> shutter;   ///< shutter of the input image, or null
    std::shared_ptr<const Volume> volume;   ///< CTA, or null
    std::optional<TableAngles> tableAngles{};   ///< as in the input, see RegistrationInput
    Messages notes{};   ///< notes on how the input was interpreted
};

/// Validates and resamples the input. The error names what makes the input unusable: an empty or invalid tree, target
/// or camera, an initial pose that is not rigid or puts vessel points behind the source, an unknown branch, or an image
/// that does not match the camera.
Result<RegistrationProblem> makeProblem(const RegistrationInput& input, const RegistrationOptions& options);

/// Returns the problem restricted to the tree points for which `isKept` is 1, with the same rotation center.
RegistrationProblem restrictProblem(const RegistrationProblem& whole, const std::vector<std::uint8_t>& isKept);

/// Returns the standard deviations of the camera errors selected by the options.
CameraUncertainty cameraUncertaintyFor(const CameraUncertainty& byOrigin, const GeometryOptions& options);

/// Returns the samples of a valid target; used for the next frame of a cine run.
TargetSamples sampleTarget(const Centerline2d& target, const RegistrationOptions& options);

}   // namespace angiopose::core
