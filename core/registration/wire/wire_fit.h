#pragma once

#include "core/registration/pose/start_prior.h"
#include "core/registration/wire/likely_ways.h"
#include "core/registration/wire/wire_alignment.h"

namespace angiopose::core {

/// A tree and a wire in an image, looked at from poses near the last full one.
struct WireProblem {
    const ProjectionCamera& camera;
    const TreeKnots& knots;
    Eigen::Vector3d centroid;   ///< patient LPS mm, what poses turn the tree about
    double spreadMm = 1.0;   ///< rms distance of the tree from it
    const WireCurve& curve;
    const WireCurve& turned;   ///< the same from the other end
    const StartPrior& prior;   ///< how far the last full pose may be off

    const WireCurve& curveOf(const TreeWay& way) const { return way.isCurveTurned ? turned : curve; }
    SeenKnots seen(const std::vector<std::size_t>& which, const CentroidPose& pose) const;
};

/// The most likely pose of one way, given that the wire takes it.
struct WireFit {
    TreeWay way;
    CentroidPose pose;
    WireAlignment alignment;
    Matrix6d covariance = Matrix6d::Zero();   ///< of steps (rad, mm) about the pose; locked ones are certain
    double logEvidence = 0.0;   ///< of the way, all poses considered (Laplace)
};

/// Lays the curve along the way and moves the pose, in turns, from a wide reach to none (ALGORITHMS §6.22).
WireFit fitWire(const WireProblem& problem, const TreeWay& way, const CentroidPose& start, const WireModel& model);

}   // namespace angiopose::core
