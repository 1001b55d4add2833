#pragma once

#include "core/registration/pose/pose_freedom.h"
#include "core/registration/problem/registration_result.h"

#include <cstdint>

namespace angiopose::core {

/// Tree as used by methods: evenly spaced points of all used branches, concatenated.
struct TreeSamples {
    std::vector<Eigen::Vector3d> points;   ///< patient LPS mm
    std::vector<Eigen::Vector3d> tangents;   ///< unit vectors
    std::vector<double> radiusMm;   ///< 0 where unknown
    std::vector<int> branchIndex;   ///< index into branchIds, ascending
    std::vector<std::uint8_t> isNode;   ///< 1: represents a bifurcation or an end
    std::vector<int> branchIds;   ///< ids of the used branches, in the tree's order
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();   ///< mean of the points; rotation center used by methods
    double spreadMm = 1.0;   ///< ρ: RMS distance of the points from their centroid

    std::size_t size() const { return points.size(); }
    bool hasRadius() const;
};

/// Traced vessels as used by methods: evenly spaced points, curves concatenated.
struct TargetSamples {
    std::vector<Eigen::Vector2d> points;   ///< px
    std::vector<Eigen::Vector2d> tangents;   ///< unit vectors
    std::vector<double> radiusPx;   ///< 0 where unknown
    std::vector<int> curveIndex;   ///< ascending

    std::size_t size() const { return points.size(); }
};

/// Validated and resampled registration input; common starting point of all methods.
struct RegistrationProblem {
    ProjectionCamera camera;
    CameraSpread cameraSpread{};   ///< according to the options
    RigidTransform start;   ///< cameraFromPatient, exactly rigid
    TreeSamples tree;   ///< without the excluded branches
    Eigen::Vector3d wholeTreeCentroid =
        Eigen::Vector3d::Zero();   ///< length-weighted, including excluded branches: the centroid shown to users
    PoseFreedom freedom;   ///< according to the locks in the options
    TargetSamples target;
    std::vector<int> auxiliary;   ///< {p'}: tree points by option `auxiliary`
    bool auxiliaryIsChosen = false;   ///< whether the user selected branches for {p'}
    std::shared_ptr<const ImageF> image;   ///< as given, in the camera's size; or null
    Polarity polarity = Polarity::VesselsDark;
    std::shared_ptr<const Mask2d> shutter;   ///< as given, or null
    std::shared_ptr<const Volume> volume;   ///< may be null
    std::optional<TableReading> tableReading{};   ///< as given
    Messages notes{};   ///< notes on how the input was interpreted
};

/// Fails with the reason that makes the input unusable: empty or invalid tree, target or camera, an initial pose that
/// is not rigid or that puts the whole tree behind the source, an unknown branch, an image that does not match the
/// camera.
Result<RegistrationProblem> makeProblem(const RegistrationInput& input, const RegistrationOptions& options);

/// Problem restricted to some of its tree points, with the same rotation center; `isKept` is 1 for each point to keep.
RegistrationProblem partOf(const RegistrationProblem& whole, const std::vector<std::uint8_t>& isKept);

/// Standard deviations of the camera errors according to the options.
CameraSpread spreadFor(const CameraSpread& byOrigin, const GeometryOptions& options);

/// Samples a valid target for the methods; used for the next frame of a run.
TargetSamples sampledTarget(const Centerline2d& target, const RegistrationOptions& options);

}   // namespace angiopose::core