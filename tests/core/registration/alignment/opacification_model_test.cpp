#include "core/registration/alignment/opacification_model.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

std::vector<Eigen::Vector3d> straight(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k <= 40; ++k) {
        points.emplace_back(from + k / 40.0 * (to - from));
    }
    return points;
}

/// A trunk of 80 mm with a branch of 40 mm leaving its middle, which bifurcates into two branches of 40 mm.
TreeSamples forkedSamples()
{
    VesselTree tree;
    tree.branches.push_back({1, "", straight({0, 0, 0}, {0, 0, 80}), {}});
    tree.branches.push_back({2, "", straight({0, 0, 40}, {40, 0, 40}), {}});
    tree.branches.push_back({3, "", straight({40, 0, 40}, {70, 0, 66}), {}});
    tree.branches.push_back({4, "", straight({40, 0, 40}, {70, 0, 14}), {}});
    RegistrationInput input;
    input.tree = tree;
    input.target.curves.push_back({1, {{10, 10}, {20, 20}}, {}});
    input.camera = {-1800.0, 1800.0, 255.5, 255.5, 512, 512};
    input.initialCameraFromPatient.translation = {0.0, 0.0, 800.0};
    return makeProblem(input, {}).value().tree;
}

struct VesselFillingTest : ::testing::Test {
    TreeSamples tree = forkedSamples();
    OpacificationModel opacification{tree};

    std::vector<std::uint8_t> likeliestStates(const std::vector<double>& gain)
    {
        return opacification.likeliestStates(gain, 6.0);
    }
};

TEST_F(VesselFillingTest, CutsBranchesWhereOthersLeaveThem)
{
    ASSERT_EQ(5U, opacification.pieces().size());   // the trunk is cut into two pieces
    EXPECT_EQ(0, opacification.pieces()[0].branchIndex);
    EXPECT_EQ(0, opacification.pieces()[1].branchIndex);
    EXPECT_EQ(opacification.pieces()[0].to, opacification.pieces()[1].from);
    EXPECT_NEAR(40.0, opacification.lengthMm(0), 2.0);
    EXPECT_EQ(tree.size(), opacification.segmentOfPoint().size());
}

TEST_F(VesselFillingTest, EmptiesATerritoryAsAWhole)
{
    using Filled = std::vector<std::uint8_t>;
    EXPECT_EQ((Filled{1, 1, 0, 0, 0}), likeliestStates({30.0, 30.0, -20.0, -20.0, -20.0}));
    EXPECT_EQ(1, opacification.countUnopacifiedTerritories(Filled{1, 1, 0, 0, 0}, 10.0));
    // A piece with weak evidence for the other state keeps the state of its neighbors.
    EXPECT_EQ((Filled{1, 1, 0, 0, 0}), likeliestStates({30.0, 30.0, -20.0, -20.0, 3.0}));
    EXPECT_EQ((Filled{1, 1, 1, 1, 1}), likeliestStates({30.0, 30.0, -4.0, 20.0, 20.0}));
}

TEST_F(VesselFillingTest, CountsTerritoriesApart)
{
    EXPECT_EQ(2, opacification.countUnopacifiedTerritories(std::vector<std::uint8_t>{1, 0, 1, 0, 1}, 10.0));
    EXPECT_EQ(1, opacification.countUnopacifiedTerritories(std::vector<std::uint8_t>{1, 1, 1, 0, 0}, 10.0));
    EXPECT_EQ(0, opacification.countUnopacifiedTerritories(std::vector<std::uint8_t>{1, 1, 1, 1, 1}, 10.0));
    EXPECT_EQ(0, opacification.countUnopacifiedTerritories(std::vector<std::uint8_t>{1, 1, 1, 0, 1}, 60.0));
}

TEST_F(VesselFillingTest, CountsForksThatAreFilled)
{
    EXPECT_EQ(2, opacification.countOpacifiedBifurcations(std::vector<std::uint8_t>{1, 1, 1, 1, 1}));
    EXPECT_EQ(1, opacification.countOpacifiedBifurcations(std::vector<std::uint8_t>{1, 1, 1, 0, 1}));
    EXPECT_EQ(0, opacification.countOpacifiedBifurcations(
                     std::vector<std::uint8_t>{1, 0, 1, 0, 1}));   // only one path passes through
}

}   // namespace
}   // namespace angiopose::core
