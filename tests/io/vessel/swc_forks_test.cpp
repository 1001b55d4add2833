#include "core/simulation/grow_tree.h"
#include "io/vessel_tree_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <sstream>

using namespace angiopose;

namespace {

long forksOf(const core::VesselTree& tree)
{
    const auto nodes = core::findNodes(tree);
    return std::ranges::count_if(nodes, &core::VesselNode::isBifurcation);
}

core::VesselTree throughSwc(const core::VesselTree& tree)
{
    const test::TemporaryFolder folder;
    const core::Status written = io::writeVesselTree(tree, folder.file("tree.swc"));
    EXPECT_TRUE(written);
    const auto read = io::readVesselTree(folder.file("tree.swc"));
    EXPECT_TRUE(read) << read.error().message;
    return read ? read.value() : core::VesselTree{};
}

core::VesselBranch straight(int id, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    core::VesselBranch branch{id, "", {}, {}};
    const int steps = std::max(1, static_cast<int>((to - from).norm()));
    for (int i = 0; i <= steps; ++i) {
        branch.pointsInPatient.emplace_back(from + (to - from) * (static_cast<double>(i) / steps));
        branch.radiusMm.push_back(1.5);
    }
    return branch;
}

/// A cerebral tree with straight branches between the nodes of its graph, in 0.5 mm voxels.
core::VesselTree cerebralTree(const std::string& name)
{
    const auto rows = [&name](const std::string& kind) {
        std::istringstream lines(test::readText(test::dataFile("cerebral-artery-graphs/csv/" + name + kind)));
        std::vector<std::vector<double>> table;
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line)) {
            std::istringstream cells(line);
            table.emplace_back();
            for (std::string cell; std::getline(cells, cell, ',');) {
                table.back().push_back(std::atof(cell.c_str()));
            }
        }
        return table;
    };
    std::map<int, Eigen::Vector3d> nodes;
    for (const auto& row : rows("_nodes.csv")) {
        nodes[static_cast<int>(row[0])] = 0.5 * Eigen::Vector3d(row[1], row[2], row[3]);
    }
    core::VesselTree tree;
    for (const auto& row : rows("_edges.csv")) {
        const int id = static_cast<int>(tree.branches.size()) + 1;
        tree.branches.push_back(straight(id, nodes[static_cast<int>(row[0])], nodes[static_cast<int>(row[1])]));
    }
    std::erase_if(tree.branches, [](const core::VesselBranch& branch) { return branch.lengthMm() == 0.0; });
    return tree;
}

TEST(SwcForks, StayWhereDaughtersBeginBeyondTheEndOfTheirMother)
{
    core::VesselTree tree;
    tree.branches.push_back(straight(1, {0, 0, 0}, {30, 0, 0}));
    tree.branches.push_back(straight(2, {34, 0, 0}, {60, 12, 0}));
    tree.branches.push_back(straight(3, {34, 0, 0}, {60, -12, 0}));
    ASSERT_EQ(forksOf(tree), 1);
    const core::VesselTree read = throughSwc(tree);
    EXPECT_EQ(forksOf(read), 1);
    ASSERT_EQ(read.branches.size(), 3U);
    EXPECT_NEAR(read.branches[0].lengthMm(), 34.0, 1e-9);   // extended to its daughter branches

    tree.branches[0] = straight(1, {30, 0, 0}, {0, 0, 0});   // runs away from them, so it is a separate vessel
    EXPECT_EQ(forksOf(throughSwc(tree)), 1);   // the other two still meet
    EXPECT_EQ(throughSwc(tree).branches.size(), 3U);
}

TEST(SwcForks, StayWhereOnlyTwoBranchesMeet)
{
    core::VesselTree tree;
    tree.branches.push_back(straight(1, {0, 0, 0}, {30, 0, 0}));
    tree.branches.push_back(straight(2, {30, 0, 0}, {30, 20, 0}));
    tree.branches.push_back(straight(3, {0, 100, 0}, {10, 100, 0}));
    const core::VesselTree read = throughSwc(tree);
    EXPECT_EQ(read.branches.size(), 3U);
    EXPECT_EQ(forksOf(read), forksOf(tree));
}

TEST(SwcForks, OfOtherProgramsMeanWhatTheyMeant)
{
    const test::TemporaryFolder folder;   // type 5 on every row, which some programs write for unknown types
    const std::string path =
        folder.write("other.swc", "1 5 0 0 0 1 -1\n2 5 5 0 0 1 1\n3 5 9 0 0 1 2\n4 5 14 0 0 1 3\n");
    const auto read = io::readVesselTree(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().branches.size(), 1U);
}

TEST(SwcForks, OfGrownTreesAllStay)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        core::TreeOptions options;
        options.branchCount = 8 + static_cast<int>(seed);
        const core::VesselTree tree = core::growTree(seed, options).tree;
        EXPECT_EQ(forksOf(throughSwc(tree)), forksOf(tree)) << "seed " << seed;
    }
}

TEST(SwcForks, OfThePhantomAllStay)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/tree");
    const auto tree = io::readVesselTree(test::dataFile("coronary-phantom-xa/tree/Centerlines.vtk").string());
    ASSERT_TRUE(tree);
    EXPECT_EQ(forksOf(tree.value()), 5);
    EXPECT_EQ(forksOf(throughSwc(tree.value())), 5);
}

TEST(SwcForks, OfCerebralTreesAllStay)
{
    ANGIOPOSE_NEEDS_DATA("cerebral-artery-graphs/csv");
    int trees = 0;
    for (const auto& file : std::filesystem::directory_iterator(test::dataFile("cerebral-artery-graphs/csv"))) {
        const std::string name = file.path().filename().string();
        if (name.ends_with("_edges.csv")) {
            const core::VesselTree tree = cerebralTree(name.substr(0, name.size() - 10));
            EXPECT_EQ(forksOf(throughSwc(tree)), forksOf(tree)) << name;
            ++trees;
        }
    }
    EXPECT_EQ(trees, 5);
}

}   // namespace
