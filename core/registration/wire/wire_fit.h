#pragma once

#include "core/registration/pose/initial_pose_prior.h"
#include "core/registration/wire/likely_paths.h"
#include "core/registration/wire/wire_alignment.h"

namespace angiopose::core {

/// Tree, wire and prior for evaluating poses near the previous registered pose.
struct WireProblem {
    const ProjectionCamera& camera;
    const TreeKnots& knots;
    Eigen::Vector3d centroid;   ///< patient LPS mm, rotation center of the poses
    double spreadMm = 1.0;   ///< RMS distance of the tree points from the centroid
    const WireCurve& curve;
    const WireCurve& reversedCurve;   ///< same curve in the opposite direction
    const InitialPosePrior& prior;   ///< errors of the previous registered pose

    const WireCurve& curveOf(const TreePath& way) const { return way.isCurveReversed ? reversedCurve : curve; }
    ProjectedKnots projected(const std::vector<std::size_t>& knotIndices, const CentroidPose& pose) const;
};

/// Most likely pose for one path, assuming that the wire follows that path.
struct WireFit {
    TreePath way;
    CentroidPose pose;
    WireAlignment alignment;
    Matrix6d covariance = Matrix6d::Zero();   ///< covariance of pose steps (rad, mm); locked components have no error
    double logEvidence = 0.0;   ///< log evidence of the path, integrated over all poses (Laplace)
};

/// Alternates between aligning the curve with the path and fitting the pose, while reducing the assumed pose error to
/// zero (ALGORITHMS §6.22).
WireFit fitWire(const WireProblem& problem, const TreePath& way, const CentroidPose& start, const WireModel& model);

}   // namespace angiopose::core
