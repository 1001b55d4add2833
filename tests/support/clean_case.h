#pragma once

#include "core/evaluation/trial/projection_error.h"
#include "core/registration/problem/registration_problem.h"
#include "core/simulation/simulated_case.h"
#include "core/support/random.h"

#include <cmath>

namespace angiopose::test {

/// A simulated tree 800 mm from the source and its exact projections, with correspondences known only to the test.
struct CleanCase {
    explicit CleanCase(std::uint64_t seed) : tree(core::simulateTree(seed))
    {
        const Eigen::Vector3d centroid = core::centroidInPatient(tree);
        truth.rotation = core::expSo3(Eigen::Vector3d(0.4, 0.3 * static_cast<double>(seed % 7), -0.2));
        truth.translation = Eigen::Vector3d(4.0, -6.0, 800.0) - truth.rotation * centroid;
        target = core::projectTree(tree, camera, truth);
    }

    /// An initial pose that is off by 2° and 5 mm on average about the centroid.
    core::RigidTransform nearbyStart(core::CounterRandom& random) const
    {
        return core::perturbAboutCentroid(truth, core::centroidInPatient(tree), 2.0 / std::sqrt(3.0),
                                          5.0 / std::sqrt(3.0), random);
    }

    core::RegistrationInput from(const core::RigidTransform& start) const
    {
        return {tree, target, camera, start, {}, {}};
    }

    core::RegistrationInput fromNearby(std::uint64_t seed) const
    {
        core::CounterRandom random(seed);
        return from(nearbyStart(random));
    }

    core::ProjectionCamera camera{-1877.0, 1877.0, 511.5, 511.5, 1024, 1024};
    core::VesselTree tree;
    core::RigidTransform truth;
    core::Centerline2d target;
};

inline core::Centerline2d jittered(core::Centerline2d target, core::CounterRandom& random)
{
    for (core::Curve2d& curve : target.curves) {
        for (Eigen::Vector2d& point : curve.pointsPx) {
            point.x() += 0.5 * random.normal();
            point.y() += 0.5 * random.normal();
        }
    }
    return target;
}

/// Mean distance of the tree's projection at a pose from its true projection, px.
inline double meanErrorPx(const CleanCase& clean, const core::RigidTransform& pose)
{
    return core::projectionError(clean.tree, clean.camera, {pose, clean.truth}).meanPx;
}

}   // namespace angiopose::test
