#include "core/evaluation/trial/cramer_rao_bound.h"

#include "core/evaluation/trial/projection_error.h"
#include "core/simulation/phantom.h"
#include "core/support/random.h"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <cmath>

using namespace angiopose;

namespace {

using namespace core;

/// ALGORITHMS §6.10: mean standard deviations of six trees with about 2000 points.
TEST(CramerRaoBound, LiesWhereItWasMeasured)
{
    Vector6d variance = Vector6d::Zero();
    Vector6d correlated = Vector6d::Zero();
    constexpr int trees = 6;
    for (std::uint64_t seed = 0; seed < trees; ++seed) {
        const Phantom phantom = makePhantom(1000 + seed, 2000);
        variance +=
            cramerRaoBound(phantom.tree, phantom.tree, phantom.camera, phantom.trueCameraFromPatient, {1.0, 0.0, false})
                .diagonal() /
            trees;
        correlated +=
            cramerRaoBound(phantom.tree, phantom.tree, phantom.camera, phantom.trueCameraFromPatient, {0.7, 5.0, false})
                .diagonal() /
            trees;
    }
    const auto degrees = [](double radians2) { return std::sqrt(radians2) * 180.0 / M_PI; };
    EXPECT_NEAR(degrees(variance[0]), 0.038, 0.025);
    EXPECT_NEAR(degrees(variance[2]), 0.022, 0.015);
    EXPECT_NEAR(std::sqrt(variance[3]), 0.016, 0.010);
    EXPECT_NEAR(std::sqrt(variance[5]), 0.43, 0.25);
    // Points that share their noise with (1 + ρ)/(1 − ρ) ≈ 10 others: 0.7·√10 times the standard deviation.
    EXPECT_NEAR(std::sqrt(correlated[5] / variance[5]), 0.7 * std::sqrt(10.03), 0.01);
}

TEST(CramerRaoBound, MissingBranchesCost)
{
    const Phantom phantom = makePhantom(1003, 1000);
    VesselTree half = phantom.tree;
    half.branches.resize(half.branches.size() / 2);
    const auto bound = [&](const VesselTree& visible) {
        return cramerRaoBound(phantom.tree, visible, phantom.camera, phantom.trueCameraFromPatient, {1.0, 0.0, false});
    };
    EXPECT_GT(bound(half)(5, 5), bound(phantom.tree)(5, 5));
}

TEST(CramerRaoBound, PredictsTheProjectionErrorOfPosesDrawnFromIt)
{
    const Phantom phantom = makePhantom(1001, 500);
    const Matrix6d covariance =
        cramerRaoBound(phantom.tree, phantom.tree, phantom.camera, phantom.trueCameraFromPatient, {0.7, 5.0, true});
    const Matrix6d root = covariance.llt().matrixL();
    const Eigen::Vector3d centroid = centroidInPatient(phantom.tree);
    CounterRandom random(9);
    double squares = 0.0;
    constexpr int draws = 400;
    for (int k = 0; k < draws; ++k) {
        Vector6d unit;
        for (int i = 0; i < 6; ++i) {
            unit[i] = random.normal();
        }
        const Vector6d error = root * unit;
        RigidTransform pose;
        pose.rotation = expSo3(error.head<3>()) * phantom.trueCameraFromPatient.rotation;
        pose.translation = phantom.trueCameraFromPatient * centroid + error.tail<3>() - pose.rotation * centroid;
        const double rmsPx = projectionError(phantom.tree, phantom.camera, {pose, phantom.trueCameraFromPatient}).rmsPx;
        squares += rmsPx * rmsPx / draws;
    }
    const double predicted = rmsProjectionPx(phantom.tree, phantom.camera, phantom.trueCameraFromPatient, covariance);
    EXPECT_NEAR(std::sqrt(squares), predicted, 0.05 * predicted);
}

}   // namespace
