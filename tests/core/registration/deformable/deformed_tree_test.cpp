#include "core/registration/deformable/deformed_tree.h"

#include <gtest/gtest.h>
#include <numbers>

namespace angiopose::core {
namespace {

VesselTree smallTree()
{
    VesselTree tree;
    tree.branches.push_back({3, "", {{0, 0, 0}, {10, 0, 0}}, {}, -1});
    tree.branches.push_back({5, "", {{10, 0, 0}, {10, 10, 0}, {10, 20, 0}}, {}, -1});
    return tree;
}

DeformableResult deformationOf(const VesselTree& tree)
{
    DeformableResult deformed;
    deformed.cameraFromPatient.translation = {0, 0, 800};
    deformed.viewPoses = {deformed.cameraFromPatient, {}};
    deformed.viewPoses[1].rotation = Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitY()).matrix();
    deformed.viewPoses[1].translation = {0, 0, 700};
    for (const VesselBranch& branch : tree.branches) {
        BranchMotion motion;
        motion.branchId = branch.id;
        motion.displacementMm.assign(branch.pointsInPatient.size(), Eigen::Vector3d(0, 1, 2) * branch.id);
        motion.covariance.assign(branch.pointsInPatient.size(), Eigen::Vector3d(0.1, 0.2, 9.0).asDiagonal());
        deformed.branches.push_back(motion);
    }
    return deformed;
}

TEST(DeformedTree, BelongsToItsTreeInAnyOrderOfBranches)
{
    VesselTree tree = smallTree();
    const DeformableResult deformed = deformationOf(tree);
    std::swap(tree.branches[0], tree.branches[1]);
    ASSERT_TRUE(isCompatible(tree, deformed));
    EXPECT_EQ(deformedTree(tree, deformed).branches[0].pointsInPatient[2], Eigen::Vector3d(10, 25, 10));
}

TEST(DeformedTree, OfAnotherTreeIsNone)
{
    const DeformableResult deformed = deformationOf(smallTree());
    VesselTree cut = smallTree();
    cut.branches[1].pointsInPatient.pop_back();
    EXPECT_TRUE(deformedTree(cut, deformed).branches.empty());
    VesselTree fewer = smallTree();
    fewer.branches.pop_back();
    EXPECT_TRUE(deformedTree(fewer, deformed).branches.empty());
    VesselTree other = smallTree();
    other.branches[1].id = 6;
    EXPECT_TRUE(deformedTreeAt(other, deformed, {}).branches.empty());
}

TEST(DeformedTree, LiesAtAnotherPoseWhereTheDeformedVesselsLie)
{
    const VesselTree tree = smallTree();
    const DeformableResult deformed = deformationOf(tree);
    RigidTransform pose;
    pose.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    pose.translation = {5, -7, 640};
    const VesselTree there = deformedTreeAt(tree, deformed, pose);
    const VesselTree moved = deformedTree(tree, deformed);
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        for (std::size_t i = 0; i < tree.branches[b].pointsInPatient.size(); ++i) {
            EXPECT_LT((pose * there.branches[b].pointsInPatient[i] -
                       deformed.cameraFromPatient * moved.branches[b].pointsInPatient[i])
                          .norm(),
                      1e-9);
        }
    }
}

TEST(DeformedTree, AlongTheRayOfOneViewNothingIsApart)
{
    const VesselTree tree = smallTree();
    const DeformableResult deformed = deformationOf(tree);
    const VesselTree there = deformedTreeAt(tree, deformed, deformed.cameraFromPatient);
    const auto inSpace = pointDistances(tree.branches[0], there.branches[0], deformed.cameraFromPatient, 2);
    const auto across = pointDistances(tree.branches[0], there.branches[0], deformed.cameraFromPatient, 1);
    ASSERT_EQ(across.size(), 2U);
    EXPECT_NEAR(inSpace[0], 3.0 * std::sqrt(5.0), 1e-9);
    EXPECT_NEAR(across[0], 3.0, 1e-9);   // the point lies on the optical axis: its ray is z
}

TEST(DeformedTree, SeenFirstFromAnotherViewIsTheSameDeformation)
{
    const VesselTree tree = smallTree();
    const DeformableResult deformed = deformationOf(tree);
    const DeformableResult other = withViewFirst(deformed, 1);
    EXPECT_EQ(other.cameraFromPatient.matrix(), deformed.viewPoses[1].matrix());
    EXPECT_EQ(other.viewPoses[1].matrix(), deformed.viewPoses[0].matrix());
    EXPECT_EQ(other.branches[1].displacementMm, deformed.branches[1].displacementMm);
    const Eigen::Matrix3d& turned = other.branches[0].covariance[0];   // the old ray is perpendicular to the new one
    EXPECT_NEAR(turned(0, 0), 9.0, 1e-6);
    EXPECT_NEAR(turned(1, 1), 0.2, 1e-6);
    EXPECT_NEAR(turned(2, 2), 0.1, 1e-6);
}

TEST(DeformedTree, IsRoundedToWhatIsKnown)
{
    BranchMotion motion;
    motion.displacementMm = {{0.12345678, -7.0004999, 1e-9}};
    motion.covariance.assign(1, Eigen::Vector3d(0.0123456, 987.654, 0.0).asDiagonal());
    roundMotion(motion);
    EXPECT_EQ(motion.displacementMm[0], Eigen::Vector3d(0.123, -7.0, 0.0));
    EXPECT_EQ(motion.covariance[0](0, 0), 0.0123);
    EXPECT_EQ(motion.covariance[0](1, 1), 988.0);
    EXPECT_EQ(motion.covariance[0](2, 2), 0.0);
}

}   // namespace
}   // namespace angiopose::core
