#include "io/motion_table.h"

#include "io/case/fields/deformation_fields.h"
#include "io/vessel_tree_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

struct MovedBranch {
    MovedBranch()
    {
        tree.branches.push_back({7, "left", {{0, 0, 0}, {0, 0, 10}}, {2.0, 1.5}, -1});
        core::BranchMotion motion;
        motion.branchId = 7;
        motion.displacementMm = {{1, 0, 0}, {0, 3, 4}};
        motion.covariance.assign(2, Eigen::Vector3d(0.01, 0.01, 4.0).asDiagonal());
        motion.seenShare = 0.75;
        deformed.branches.push_back(motion);
        deformed.verdict = core::DeformationVerdict::Deformed;
    }

    core::VesselTree tree;
    core::DeformableResult deformed;
};

TEST(MotionTable, IsACenterlineTableWithTheMotionBeside)
{
    const test::TemporaryFolder folder;
    const MovedBranch moved;
    const std::string path = folder.file("motion.csv");
    ASSERT_TRUE(writeMotion(moved.tree, moved.deformed, path));

    std::ifstream file(path);
    std::string header, first, second;
    std::getline(file, header);
    std::getline(file, first);
    std::getline(file, second);
    EXPECT_EQ(header, "x,y,z,radius,branch,dx,dy,dz,inPlaneSigma,depthSigma");
    EXPECT_EQ(first, "0,0,0,2,7,1,0,0,0.1,2");
    EXPECT_EQ(second, "0,0,10,1.5,7,0,3,4,0.1,2");
    const auto tree = readVesselTree(path);
    ASSERT_TRUE(tree) << tree.error().message;
    EXPECT_EQ(tree.value().branches.front().id, 7);
}

TEST(MotionTable, AnUnwritablePathIsAnError)
{
    const MovedBranch moved;
    EXPECT_FALSE(writeMotion(moved.tree, moved.deformed, "/no/such/folder/motion.csv"));
}

TEST(DeformedSummary, SaysWhatMovedHowFar)
{
    const MovedBranch moved;
    const Json json = deformationSummary(moved.deformed);
    EXPECT_EQ(json["verdict"], "bent");
    EXPECT_EQ(json["perBranch"][0]["branch"], 7);
    EXPECT_EQ(json["perBranch"][0]["largestMotionMm"], 5.0);
    EXPECT_EQ(json["perBranch"][0]["meanMotionMm"], 3.0);
    EXPECT_EQ(json["perBranch"][0]["seenShare"], 0.75);
    EXPECT_TRUE(json["messages"].is_array());
}

}   // namespace
}   // namespace angiopose::io
