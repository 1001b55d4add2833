#pragma once

#include "core/registration/pose/pose_freedom.h"
#include "core/registration/problem/registration_result.h"

#include <cstdint>

namespace angiopose::core {

/// The tree as methods see it: evenly spaced points of all used branches, one after the other.
struct TreeSamples {
    std::vector<Eigen::Vector3d> points;   ///< patient LPS mm
    std::vector<Eigen::Vector3d> tangents;   ///< unit
    std::vector<double> radiusMm;   ///< 0 where unknown
    std::vector<int> branchIndex;   ///< into branchIds, ascending
    std::vector<std::uint8_t> isNode;   ///< 1: stands for a bifurcation or an end
    std::vector<int> branchIds;   ///< of the used branches, in the tree's order
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();   ///< mean of the points; what methods turn them about
    double spreadMm = 1.0;   ///< ρ: rms distance of the points from their centroid

    std::size_t size() const { return points.size(); }
    bool hasRadius() const;
};

/// The traced vessels as methods see them: evenly spaced points, one curve after the other.
struct TargetSamples {
    std::vector<Eigen::Vector2d> points;   ///< px
    std::vector<Eigen::Vector2d> tangents;   ///< unit
    std::vector<double> radiusPx;   ///< 0 where unknown
    std::vector<int> curveIndex;   ///< ascending

    std::size_t size() const { return points.size(); }
};

/// A registration input checked and resampled once; what every method starts from.
struct RegistrationProblem {
    ProjectionCamera camera;
    CameraSpread cameraSpread{};   ///< as the options want it
    RigidTransform start;   ///< cameraFromPatient, exactly rigid
    TreeSamples tree;   ///< without the excluded branches
    Eigen::Vector3d wholeTreeCentroid = Eigen::Vector3d::Zero();   ///< by length, excluded branches too: what users see
    PoseFreedom freedom;   ///< by the options' locks
    TargetSamples target;
    std::vector<int> auxiliary;   ///< {p'}: tree points by option `auxiliary`
    bool auxiliaryIsChosen = false;   ///< the user named branches for {p'}
    std::shared_ptr<const ImageF> image;   ///< as given, the size of the camera's; or null
    Polarity polarity = Polarity::VesselsDark;
    std::shared_ptr<const Mask2d> shutter;   ///< as given, or null
    std::shared_ptr<const Volume> volume;   ///< or null
    std::optional<TableReading> tableReading{};   ///< as given
    Messages notes{};   ///< what was made of the input
};

/// Fails naming what makes the input unusable: empty or broken tree, target or camera, a start pose that is not rigid
/// or that puts the whole tree behind the source, an unknown branch, an image that the camera does not take.
Result<RegistrationProblem> makeProblem(const RegistrationInput& input, const RegistrationOptions& options);

/// The problem with some of its tree points only, turned about the same centroid; `isKept`: 1 for each that stays.
RegistrationProblem partOf(const RegistrationProblem& whole, const std::vector<std::uint8_t>& isKept);

/// How far a camera may be off as the options want it.
CameraSpread spreadFor(const CameraSpread& byOrigin, const GeometryOptions& options);

/// A target that is free of problems, as methods see it; for the next frame of a run.
TargetSamples sampledTarget(const Centerline2d& target, const RegistrationOptions& options);

}   // namespace angiopose::core