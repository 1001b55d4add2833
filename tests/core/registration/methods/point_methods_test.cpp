#include "core/registration/methods/method.h"
#include "core/registration/pnp/distance_descent.h"
#include "core/registration/pnp/seed_problem.h"
#include "tests/core/registration/methods/tested_methods.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using namespace core;
using test::CleanCase;
using test::exactSamplesBy;

RigidTransform poseOf(const RegistrationInput& input, const RegistrationOptions& options)
{
    const Result<RegistrationProblem> problem = makeProblem(input, options);
    EXPECT_TRUE(problem) << (problem ? "" : problem.error().message.text());
    const IterationObserver none;
    ProgressLog progress(problem.value(), none);
    return findMethod(options.method)->solve(problem.value(), options, progress).cameraFromPatient;
}

double depthOffMm(const CleanCase& clean, const RigidTransform& pose)
{
    const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
    return (pose * centroid - clean.truth * centroid).z();
}

TEST(DtIcp, BothSolversAndTheAffineStageFindTheExactPose)
{
    const CleanCase clean(2);
    const RegistrationInput input = clean.fromNearby(5);
    RegistrationOptions options = exactSamplesBy("dt-icp");
    EXPECT_LT(meanErrorPx(clean, poseOf(input, options)), 0.01);
    options.icp.model = IcpModel::Affine;
    EXPECT_LT(meanErrorPx(clean, poseOf(input, options)), 0.01);
    options.icp.solver = DescentSolver::Lbfgs;
    EXPECT_LT(meanErrorPx(clean, poseOf(input, options)), 0.1);
}

// Known behavior of the method (ALGORITHMS §3.6): shrinking always lowers a one-sided distance, so with branches
// missing from the image the tree runs away along the ray.
TEST(DtIcp, RunsAwayInDepthWhereTheImageShowsLittle)
{
    CleanCase clean(1);
    clean.target.curves.resize(2);
    const RegistrationInput input = clean.fromNearby(1);
    EXPECT_GT(std::abs(depthOffMm(clean, poseOf(input, exactSamplesBy("dt-icp")))), 100.0);
}

TEST(DistanceDescent, GradientOfTheSmoothSolverLeadsDownhill)
{
    const CleanCase clean(2);
    const RegistrationInput input = clean.fromNearby(9);
    const auto problem = makeProblem(input, exactSamplesBy("dt-icp"));
    const SeedProblem seed = makeSeedProblem(problem.value(), exactSamplesBy("dt-icp"));
    const KernelProblem full = seed.full(clean.camera);
    const auto loss = [&](const RigidTransform& pose) {
        KernelDistances distances;
        measureDistances(full, pose, distances);
        return huberLoss(full, distances, 5.0);
    };
    KernelDistances distances;
    measureDistances(full, {}, distances);
    const NormalEquations equations = huberEquations(full, distances, 5.0);
    for (int k = 0; k < 6; ++k) {
        const Vector6d step = 1e-6 * Vector6d::Unit(k);
        const double slope = (loss(expSe3(step)) - loss(expSe3(-step))) / 2e-6;
        EXPECT_NEAR(2.0 * equations.gradient(k), slope, 1e-3 * std::max(1.0, std::abs(slope))) << k;
    }
}

// The literal step (ALGORITHMS §3.3) rotates about the source only, so the missing shift is never recovered.
TEST(Nicp, LiteralStepsHardlyShift)
{
    const CleanCase clean(1);
    const RigidTransform start =
        RigidTransform{Eigen::Matrix3d::Identity(), Eigen::Vector3d(3.0, 4.0, 0.0)} * clean.truth;
    RegistrationOptions options = exactSamplesBy("nicp");
    options.nicp.iterations = 60;
    options.nicp.step = StepMetric::Literal;
    const RigidTransform motion = poseOf(clean.from(start), options) * start.inverse();
    EXPECT_LT(motion.translation.norm(), 0.05);
    EXPECT_GT(angleBetween(motion.rotation, Eigen::Matrix3d::Identity()) * 800.0, 1.0);
}

TEST(Nicp, ThePriorHoldsItBack)
{
    const CleanCase clean(1);
    const RegistrationInput input = clean.fromNearby(3);
    RegistrationOptions options = exactSamplesBy("nicp");
    options.nicp.iterations = 60;
    options.seed.preset = PriorPreset::SeedMean;
    const RigidTransform free = poseOf(input, options);
    options.nicp.prior = true;
    const RigidTransform held = poseOf(input, options);
    const auto movedMm = [&](const RigidTransform& pose) {
        return (pose * input.initialCameraFromPatient.inverse()).translation.norm();
    };
    EXPECT_LT(movedMm(held), 0.5 * movedMm(free));
}

// With its position fixed, the tree can still rotate about the source: the overlay is found and the shift stays hidden
// (ALGORITHMS §0, F1).
TEST(Nicp, ThePriorLeavesTheTurnToIt)
{
    const CleanCase clean(2);
    Vector6d twist;
    twist << 0.010, -0.012, 0.008, 3.0, 4.0, 0.0;
    RegistrationOptions options = exactSamplesBy("nicp");
    options.seed.preset = PriorPreset::SeedMean;
    options.nicp.prior = true;
    const RigidTransform start = expSe3(twist) * clean.truth;
    const RigidTransform pose = poseOf(clean.from(start), options);
    EXPECT_LT(meanErrorPx(clean, pose), 1.5);
    EXPECT_NEAR((pose * clean.truth.inverse()).translation.norm(), 5.0, 0.1);
}

TEST(Alternation, TakesAnyMethodOfPoints)
{
    const CleanCase clean(3);
    const RegistrationInput input = clean.fromNearby(6);
    for (const std::string_view method : {"dt-icp", "assembled-icp"}) {
        RegistrationOptions options = exactSamplesBy(method);
        options.icp.alternate = true;
        EXPECT_LT(meanErrorPx(clean, poseOf(input, options)), 0.01) << method;
    }
}

TEST(Neighbors, MoreOfThemStillLeadToThePose)
{
    const CleanCase clean(2);
    const RegistrationInput input = clean.fromNearby(4);
    for (const Neighbors rule : {Neighbors::Closest, Neighbors::Five, Neighbors::Radius}) {
        RegistrationOptions options = exactSamplesBy("iterative-pnp");
        options.seed.neighbors = rule;
        EXPECT_LT(meanErrorPx(clean, poseOf(input, options)), 0.5) << static_cast<int>(rule);
    }
}

TEST(Neighbors, GradientOfTheirKernelSumMatchesDifferences)
{
    const CleanCase clean(2);
    CounterRandom random(8);
    RegistrationOptions options = exactSamplesBy("iterative-pnp");
    options.seed.neighbors = Neighbors::Five;
    const auto problem = makeProblem(clean.from(clean.nearbyStart(random)), options);
    const SeedProblem seed = makeSeedProblem(problem.value(), options);
    const KernelProblem full = seed.full(clean.camera);
    const double scalePx = 9.0;
    const auto loss = [&](const RigidTransform& pose) {
        KernelDistances distances;
        measureDistances(full, pose, distances, scalePx);
        return kernelLoss(distances, scalePx);
    };
    KernelDistances distances;
    measureDistances(full, {}, distances, scalePx);
    EXPECT_EQ(distances.otherMatches.size(), 4 * full.points.size());
    const NormalEquations equations = kernelEquations(full, distances, scalePx);
    for (int k = 0; k < 6; ++k) {
        const Vector6d step = 1e-7 * Vector6d::Unit(k);
        const double slope = (loss(expSe3(step)) - loss(expSe3(-step))) / 2e-7;
        EXPECT_NEAR(equations.gradient(k) / (scalePx * scalePx), slope, 1e-2 * std::max(0.1, std::abs(slope))) << k;
    }
}

TEST(AuxiliaryPoints, FollowTheOption)
{
    const CleanCase clean(5);
    RegistrationOptions options = exactSamplesBy("dynaweight");
    const auto choose = [&](AuxiliarySet set, std::vector<int> branchIds) {
        options.seed.auxiliary = set;
        RegistrationInput input = clean.from(clean.truth);
        input.auxiliaryBranchIds = std::move(branchIds);
        return makeProblem(input, options).value();
    };
    const int branch = clean.tree.branches[1].id;
    const RegistrationProblem nodes = choose(AuxiliarySet::Chosen, {});
    EXPECT_EQ(nodes.auxiliary, choose(AuxiliarySet::Nodes, {branch}).auxiliary);
    EXPECT_EQ(choose(AuxiliarySet::Chosen, {branch}).auxiliary.size(), clean.tree.branches[1].pointsInPatient.size());

    const RegistrationProblem main = choose(AuxiliarySet::MainBranches, {});
    EXPECT_GE(main.auxiliary.size(), main.tree.size() / 3);
    EXPECT_LT(main.auxiliary.size(), 2 * main.tree.size() / 3);

    options.seed.auxiliaryCount = 25;
    const RegistrationProblem random = choose(AuxiliarySet::Random, {});
    EXPECT_EQ(random.auxiliary.size(), 25U);
    EXPECT_TRUE(std::is_sorted(random.auxiliary.begin(), random.auxiliary.end()));
    EXPECT_EQ(random.auxiliary, choose(AuxiliarySet::Random, {}).auxiliary);
    options.randomSeed = 2;
    EXPECT_NE(random.auxiliary, choose(AuxiliarySet::Random, {}).auxiliary);
}

}   // namespace
