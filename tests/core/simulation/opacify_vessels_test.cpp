#include "core/simulation/opacify_vessels.h"

#include <gtest/gtest.h>
#include <set>

using namespace angiopose;

namespace {

using namespace core;

std::set<int> idSetOf(const VesselTree& tree)
{
    std::set<int> ids;
    for (const VesselBranch& branch : tree.branches) {
        ids.insert(branch.id);
    }
    return ids;
}

TEST(FillVessels, NoFilledBranchHangsOnAnEmptyOne)
{
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const GrownTree grown = growTree(seed, {});
        CounterRandom random(seed);
        const OpacifiedVessels vessels = opacifyVessels(grown, {.missingBranchShare = 0.4}, random);
        EXPECT_EQ(vessels.missingBranchIds.size(), 10u);   // 0.4 of 24 branches
        const std::set<int> visible = idSetOf(vessels.visible);
        for (std::size_t b = 1; b < grown.tree.branches.size(); ++b) {
            const auto parent = static_cast<std::size_t>(grown.takeoffs[b].parentIndex);
            if (visible.contains(grown.tree.branches[b].id)) {
                EXPECT_TRUE(visible.contains(grown.tree.branches[parent].id)) << seed;
            }
        }
    }
}

TEST(FillVessels, ExtraVesselsHaveNewIds)
{
    const GrownTree grown = growTree(1, {});
    CounterRandom random(1);
    const OpacifiedVessels vessels =
        opacifyVessels(grown, {.missingBranchShare = 0.0, .extraBranchShare = 1.0}, random);
    EXPECT_EQ(vessels.visible.branches.size(), 48u);
    EXPECT_EQ(idSetOf(vessels.visible).size(), 48u);
    EXPECT_FALSE(findProblem(vessels.visible));
}

TEST(FillVessels, TheCatheterIsFilledBeforeTheVesselsAndLeadsToTheirInlet)
{
    const GrownTree grown = growTree(2, {});
    CounterRandom random(2);
    const OpacifiedVessels with = opacifyVessels(grown, {.extraBranchShare = 0.0, .catheterProbability = 1.0}, random);
    ASSERT_EQ(with.paths.size(), with.visible.branches.size() + 1);
    const ContrastPath& catheter = with.paths.back();
    EXPECT_LT(catheter.front().pathMm, -200.0);
    EXPECT_NEAR(catheter.back().pathMm, 0.0, 1e-9);
    const Eigen::Vector3d inlet = grown.tree.branches.front().pointsInPatient.front();
    EXPECT_LT((catheter.back().pointInPatient - inlet).norm(), 3.0);   // inside the lumen
}

TEST(FillVessels, BloodReachesAChildAfterItsParent)
{
    const GrownTree grown = growTree(3, {});
    CounterRandom random(3);
    const OpacifiedVessels vessels = opacifyVessels(grown, {.missingBranchShare = 0.0}, random);
    for (std::size_t b = 1; b < grown.tree.branches.size(); ++b) {
        const Takeoff& takeoff = grown.takeoffs[b];
        const ContrastPath& parent = vessels.paths[static_cast<std::size_t>(takeoff.parentIndex)];
        EXPECT_DOUBLE_EQ(vessels.paths[b].front().pathMm, parent[takeoff.parentPoint].pathMm);
        for (const ContrastPoint& point : vessels.paths[b]) {
            EXPECT_GE(point.opacity, 0.0);
            EXPECT_LE(point.opacity, 1.0);
            EXPECT_LE(point.pathMm, vessels.maxPathMm);
        }
    }
}

}   // namespace
