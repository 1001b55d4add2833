#include "core/registration/pnp/seed_problem.h"

#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;
using test::CleanCase;

SeedProblem seedProblem(const CleanCase& clean, PriorPreset preset)
{
    RegistrationOptions options;
    options.seed.preset = preset;
    return makeSeedProblem(makeProblem(clean.from(clean.truth), options).value(), options);
}

TEST(SeedProblem, PresetsWeighThePriorAsSpecified)
{
    const CleanCase clean(1);
    const SeedProblem sum = seedProblem(clean, PriorPreset::SeedSum);
    const SeedProblem mean = seedProblem(clean, PriorPreset::SeedMean);
    const SeedProblem metric = seedProblem(clean, PriorPreset::SeedMetric);
    const SeedProblem none = seedProblem(clean, PriorPreset::NoPrior);
    const auto count = static_cast<double>(sum.points.size());
    EXPECT_EQ(sum.prior.strength, 100.0);
    EXPECT_EQ(mean.prior.strength, 100.0 * count);
    EXPECT_EQ(mean.prior.weights, Vector6d::Ones());
    EXPECT_EQ(metric.prior.strength, 100.0 * count);
    EXPECT_NEAR(metric.prior.weights(5), 1.0 / 800.0, 1e-5);
    EXPECT_EQ(metric.prior.weights(0), 1.0);
    EXPECT_EQ(none.prior.strength, 0.0);
}

TEST(SeedProblem, OnlyTheFreePresetNeedsTheDepthGuard)
{
    const CleanCase clean(1);
    EXPECT_TRUE(std::isinf(seedProblem(clean, PriorPreset::SeedSum).schedule.maxDepthMm));
    const SeedProblem none = seedProblem(clean, PriorPreset::NoPrior);
    EXPECT_NEAR(none.schedule.minDepthMm, 700.0, 2.0);
    EXPECT_NEAR(none.schedule.maxDepthMm, 900.0, 2.0);
}

TEST(SeedProblem, PointsStandWhereTheInitialPosePutsThem)
{
    const CleanCase clean(2);
    RegistrationOptions options;
    options.resample = false;
    const RegistrationProblem problem = makeProblem(clean.from(clean.truth), options).value();
    const SeedProblem seed = makeSeedProblem(problem, options);
    ASSERT_EQ(seed.points.size(), clean.tree.pointCount());
    EXPECT_LT((seed.points[0] - clean.truth * clean.tree.branches[0].pointsInPatient[0]).norm(), 1e-9);
    EXPECT_EQ(seed.auxiliary.size(), problem.auxiliary.size());
    EXPECT_GE(seed.auxiliary.size(), findNodes(clean.tree).size() / 2);
}

TEST(SeedProblem, FourWellSpreadPointsCanFixAPose)
{
    const std::vector<Eigen::Vector3d> tree{{-50, 0, 0}, {50, 0, 0}, {0, 50, 0}, {0, -50, 0}, {0, 0, 50}, {0, 0, -50}};
    EXPECT_TRUE(determinesPose({tree.begin(), tree.begin() + 4}, tree));
    EXPECT_FALSE(determinesPose({tree.begin(), tree.begin() + 3}, tree));
    EXPECT_FALSE(determinesPose({{10, 0, 0}, {-10, 0, 0}, {0, 10, 0}, {0, -10, 0}}, tree));
    EXPECT_FALSE(determinesPose({}, tree));
}

}   // namespace
