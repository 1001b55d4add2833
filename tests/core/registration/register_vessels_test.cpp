#include "core/registration/registration.h"

#include "core/evaluation/projection_error.h"
#include "core/simulation/simulated_case.h"

#include <gtest/gtest.h>

namespace core {
namespace {

/// A tree before the C-arm, seen from the front, and its exact projection.
struct Scene {
    VesselTree tree;
    ProjectionCamera camera{-1877.0, 1877.0, 255.5, 255.5, 512, 512};
    RigidTransform truth;
    Eigen::Vector3d centroid;

    explicit Scene(std::uint64_t seed) : tree(simulateTree(seed)), centroid(centroidInPatient(tree))
    {
        truth.rotation << -1, 0, 0, 0, 0, -1, 0, -1, 0;
        truth.translation = Eigen::Vector3d(0, 0, 800) - truth.rotation * centroid;
    }

    RegistrationInput input(double rotationStdDeg, double translationStdMm, std::uint64_t trial) const
    {
        CounterRandom random = CounterRandom(17).fork(trial);
        RegistrationInput input;
        input.tree = tree;
        input.target = projectTree(tree, camera, truth);
        input.camera = camera;
        input.initialCameraFromPatient =
            perturbedAboutCentroid(truth, centroid, rotationStdDeg, translationStdMm, random);
        return input;
    }
};

TEST(RegisterVessels, RecoversKnownPoseFromNearbyStart)
{
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Scene scene(seed);
        const auto result = registerVessels(scene.input(2.0, 5.0, seed));
        ASSERT_TRUE(result);
        const PosePair poses{result.value().cameraFromPatient, scene.truth};
        EXPECT_LT(projectionError(scene.tree, scene.camera, poses).meanPx, 0.1) << "tree " << seed;
        EXPECT_TRUE(result.value().trustworthy) << "tree " << seed;
        EXPECT_EQ(result.value().stopReason, StopReason::Converged);
    }
}

TEST(RegisterVessels, SameInputGivesSameBits)
{
    const Scene scene(4);
    RegistrationOptions options;
    const auto once = registerVessels(scene.input(2.0, 5.0, 1), options);
    options.threads = 4;
    const auto again = registerVessels(scene.input(2.0, 5.0, 1), options);
    ASSERT_TRUE(once && again);
    EXPECT_EQ(once.value().cameraFromPatient.matrix(), again.value().cameraFromPatient.matrix());
    EXPECT_EQ(once.value().uncertainty.covariance, again.value().uncertainty.covariance);
}

TEST(RegisterVessels, StopKeepsTheBestPoseSoFar)
{
    const Scene scene(5);
    const RegistrationInput input = scene.input(2.0, 5.0, 1);
    int reports = 0;
    IterationReport last;
    const auto result = registerVessels(input, {}, [&](const IterationReport& report) {
        last = report;
        return ++reports == 3 ? Verdict::Stop : Verdict::Continue;
    });
    ASSERT_TRUE(result);
    EXPECT_EQ(reports, 3);
    EXPECT_EQ(result.value().stopReason, StopReason::StoppedByUser);
    EXPECT_EQ(result.value().history.size(), 3u);
    EXPECT_EQ(result.value().cameraFromPatient.matrix(), last.cameraFromPatient.matrix());
    EXPECT_FALSE(result.value().trustworthy);
}

}   // namespace
}   // namespace core
