#pragma once

#include "core/registration/pose/start_prior.h"
#include "core/registration/wire/likely_ways.h"
#include "core/registration/wire/wire_alignment.h"

namespace angiopose::core {

/// Tree and wire in an image, evaluated at poses near the last full one.
struct WireProblem {
    const ProjectionCamera& camera;
    const TreeKnots& knots;
    Eigen::Vector3d centroid;   ///< patient LPS mm, rotation center of the poses
    double spreadMm = 1.0;   ///< RMS distance of the tree from the centroid
    const WireCurve& curve;
    const WireCurve& turned;   ///< same curve in the opposite direction
    const StartPrior& prior;   ///< errors of the last full pose

    const WireCurve& curveOf(const TreeWay& way) const { return way.isCurveTurned ? turned : curve; }
    ObservedKnots seen(const std::vector<std::size_t>& which, const CentroidPose& pose) const;
};

/// Most likely pose for one path, assuming that the wire follows it.
struct WireFit {
    TreeWay way;
    CentroidPose pose;
    WireAlignment alignment;
    Matrix6d covariance = Matrix6d::Zero();   ///< of steps (rad, mm) about the pose; locked ones are exact
    double logEvidence = 0.0;   ///< evidence of the path over all poses (Laplace)
};

/// Alternates between aligning the curve with the path and fitting the pose, reducing the search range from wide to
/// zero (ALGORITHMS §6.22).
WireFit fitWire(const WireProblem& problem, const TreeWay& way, const CentroidPose& start, const WireModel& model);

}   // namespace angiopose::core
