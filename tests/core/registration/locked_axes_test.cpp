#include "core/geometry/pose_offset.h"
#include "core/registration/register_views.h"
#include "core/registration/registration.h"
#include "tests/core/registration/methods/tested_methods.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

using namespace angiopose;

// Quantities that stay fixed when degrees of freedom are locked, for every method.

namespace {

using namespace core;

/// A small tree with its exact projections and an initial pose that is wrong in some degrees of freedom only.
struct LockedCase {
    explicit LockedCase(std::uint64_t seed) : tree(simulateTree(seed, {10, 120.0, 3.0, 2.0}))
    {
        truth.rotation = expSo3(Eigen::Vector3d(0.4, 0.3, -0.2));
        truth.translation = Eigen::Vector3d(4.0, -6.0, 800.0) - truth.rotation * centroidInPatient(tree);
    }

    RegistrationInput from(const PoseOffset& offset) const
    {
        RegistrationInput input;
        input.tree = tree;
        input.camera = camera;
        input.target = projectTree(tree, camera, truth);
        input.initialCameraFromPatient = applyOffset(truth, offset, centroidInPatient(tree), camera);
        return input;
    }

    PoseOffset fromTruth(const RigidTransform& pose) const
    {
        return offsetBetween(truth, pose, centroidInPatient(tree), camera);
    }

    ProjectionCamera camera{-1877.0, 1877.0, 255.5, 255.5, 512, 512};
    VesselTree tree;
    RigidTransform truth;
};

RegistrationOptions methodLocking(std::string_view method, std::initializer_list<PoseAxis> axes)
{
    RegistrationOptions options = test::exactSamplesBy(method);
    options.evolution.evaluations = 600;
    options.particle.count = 60;
    options.rgbr.hypotheses = 60;
    for (const PoseAxis axis : axes) {
        options.locks[static_cast<std::size_t>(axis)] = true;
    }
    return options;
}

bool respectsLocks(std::string_view method)
{
    return method != "assembled-icp";
}

class LockedAxes : public testing::TestWithParam<std::string_view> {};

TEST_P(LockedAxes, KeepTheirValueExactly)
{
    const LockedCase locked(3);
    const RegistrationInput input = locked.from(
        {.rightMm = 2.0, .upMm = -1.5, .alongRayMm = 6.0, .rollDeg = 1.0, .laoRaoDeg = -1.2, .craCauDeg = 0.8});
    const PoseOffset before = locked.fromTruth(input.initialCameraFromPatient);
    RegistrationInput counted = input;
    counted.lockReference = locked.truth;
    const RegistrationOptions options =
        methodLocking(GetParam(), {PoseAxis::AlongRay, PoseAxis::LaoRao, PoseAxis::Right});
    const auto result = registerVessels(counted, options);
    if (!respectsLocks(GetParam())) {
        ASSERT_FALSE(result);
        EXPECT_NE(result.error().message.text().find("cannot lock any"), std::string::npos);
        return;
    }
    ASSERT_TRUE(result) << result.error().message;
    const PoseOffset after = locked.fromTruth(result.value().cameraFromPatient);
    EXPECT_NEAR(after.alongRayMm, before.alongRayMm, 1e-9);
    EXPECT_NEAR(after.laoRaoDeg, before.laoRaoDeg, 1e-9);
    EXPECT_NEAR(after.rightMm, before.rightMm, 1e-9);
    EXPECT_GT(std::abs(after.upMm - before.upMm) + std::abs(after.rollDeg - before.rollDeg), 0.05);
    const PoseUncertainty& uncertainty = result.value().uncertainty;
    EXPECT_LT(uncertainty.depthMm, 0.01);   // certain at the pivot, which is slightly off the mean of the points
    EXPECT_TRUE(uncertainty.observed[5]);
    EXPECT_GT(uncertainty.covariance(4, 4), 0.0);
}

TEST_P(LockedAxes, FindTheOthersWhenTheLockedAreRight)
{
    if (!respectsLocks(GetParam())) {
        GTEST_SKIP() << "refuses locks";
    }
    const LockedCase locked(3);
    const RegistrationInput input = locked.from({.upMm = 2.0, .rollDeg = 1.0});
    const auto result = registerVessels(
        input, methodLocking(GetParam(), {PoseAxis::Right, PoseAxis::AlongRay, PoseAxis::LaoRao, PoseAxis::CraCau}));
    ASSERT_TRUE(result) << result.error().message;
    const PoseOffset off = locked.fromTruth(result.value().cameraFromPatient);
    EXPECT_NEAR(off.upMm, 0.0, 0.5);
    EXPECT_NEAR(off.rollDeg, 0.0, 0.4);
    EXPECT_NEAR(off.alongRayMm, 0.0, 1e-9);
}

TEST_P(LockedAxes, LeaveOneFree)
{
    if (!respectsLocks(GetParam())) {
        GTEST_SKIP() << "refuses locks";
    }
    const LockedCase locked(4);
    const RegistrationInput input = locked.from({.upMm = 2.0});
    const auto result =
        registerVessels(input, methodLocking(GetParam(), {PoseAxis::Right, PoseAxis::AlongRay, PoseAxis::Roll,
                                                          PoseAxis::LaoRao, PoseAxis::CraCau}));
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_NEAR(locked.fromTruth(result.value().cameraFromPatient).upMm, 0.0, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Methods, LockedAxes, testing::ValuesIn(test::treeMethodIds()), test::methodTestName);

TEST(LockedAxesOfAngioPose, AreExactAndTheRestIsFoundWithTrueLocks)
{
    const LockedCase locked(5);
    RegistrationInput input = locked.from({.rightMm = 25.0, .upMm = -14.0, .rollDeg = 9.0, .craCauDeg = 5.0});
    input.lockReference = locked.truth;
    const std::initializer_list<PoseAxis> held{PoseAxis::AlongRay, PoseAxis::LaoRao};
    const auto result = registerVessels(input, methodLocking("angiopose", held));
    ASSERT_TRUE(result);
    const PoseOffset off = locked.fromTruth(result.value().cameraFromPatient);
    for (const PoseAxis axis : poseAxes) {
        EXPECT_NEAR(valueOf(off, axis), 0.0, std::ranges::count(held, axis) > 0 ? 1e-6 : 0.01) << idOf(axis);
    }
}

TEST(LockedAxesOfAngioPose, HoldForTheWholeTreeThoughBranchesAreExcluded)
{
    const LockedCase locked(5);
    RegistrationInput input = locked.from({.rightMm = 3.0, .alongRayMm = 4.0, .craCauDeg = 2.0});
    input.excludedBranchIds = {locked.tree.branches[1].id, locked.tree.branches[4].id};
    const auto result = registerVessels(input, methodLocking("angiopose", {PoseAxis::AlongRay}));
    ASSERT_TRUE(result);
    EXPECT_NEAR(locked.fromTruth(result.value().cameraFromPatient).alongRayMm, 4.0, 1e-9);
}

TEST(LockedAxesOfAngioPose, LockingAllOrSeveralViewsIsRefused)
{
    const LockedCase locked(3);
    const RegistrationInput input = locked.from({.upMm = 2.0});
    RegistrationOptions options;
    options.locks.fill(true);
    EXPECT_NE(findProblem(options)->text().find("nothing to optimize"), std::string::npos);
    EXPECT_FALSE(registerVessels(input, options));
    const std::vector<RegistrationInput> views{input, input};
    EXPECT_FALSE(registerViews(views, methodLocking("angiopose", {PoseAxis::Roll})));
}

}   // namespace
