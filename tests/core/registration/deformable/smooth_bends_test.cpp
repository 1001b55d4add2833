#include "core/registration/deformable/smooth_bends.h"

#include "core/registration/deformable/bent_tree.h"
#include "core/support/random.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

constexpr double noiseMm = 0.5;

VesselTree straightTree()
{
    VesselBranch branch;
    for (int i = 0; i < 40; ++i) {
        branch.pointsInPatient.emplace_back(0.0, 0.0, i);
    }
    VesselTree tree;
    tree.branches.push_back(branch);
    return tree;
}

RigidTransform poseAt(int frame)
{
    return {expSo3({0.0, 0.01 * frame, 0.3}), {2.0 * frame, 0.0, 700.0}};
}

/// Points that move evenly to the side, seen with noise.
BendInTime seenAt(const VesselTree& tree, int frame, double sizeMm, CounterRandom& random)
{
    auto bent = std::make_shared<DeformableResult>();
    bent->cameraFromPatient = poseAt(frame);
    bent->viewPoses = {poseAt(frame)};
    BranchMotion motion;
    for (std::size_t i = 0; i < tree.branches.front().pointsInPatient.size(); ++i) {
        motion.displacementMm.emplace_back(0.1 * frame + sizeMm * random.normal(), sizeMm * random.normal(),
                                           sizeMm * random.normal());
        motion.covariance.emplace_back(noiseMm * noiseMm * Eigen::Matrix3d::Identity());
    }
    bent->branches.push_back(motion);
    return {frame, poseAt(frame), bent};
}

double errorMm(const std::vector<BendInTime>& bends)
{
    double squares = 0.0;
    double count = 0.0;
    for (const BendInTime& each : bends) {
        for (const Eigen::Vector3d& displacement : each.bent->branches.front().displacementMm) {
            squares += (displacement - Eigen::Vector3d(0.1 * each.frame, 0.0, 0.0)).squaredNorm();
            count += 1.0;
        }
    }
    return std::sqrt(squares / count);
}

TEST(SmoothInTime, TakesNoiseOutOfEvenMotion)
{
    const VesselTree tree = straightTree();
    CounterRandom random(7);
    std::vector<BendInTime> bends;
    for (int frame = 0; frame < 30; ++frame) {
        bends.push_back(seenAt(tree, frame, noiseMm, random));
    }
    const std::vector<BendInTime> smooth = smoothInTime(tree, bends);
    ASSERT_EQ(smooth.size(), bends.size());
    EXPECT_LT(errorMm(smooth), 0.6 * errorMm(bends));
    EXPECT_EQ(smooth[3].bent->branches.front().covariance[5], bends[3].bent->branches.front().covariance[5]);
}

TEST(SmoothInTime, LeavesFastMotionWhereItIsSeenWell)
{
    const VesselTree tree = straightTree();
    CounterRandom random(8);
    std::vector<BendInTime> bends;
    for (const int frame : {0, 1, 2, 20, 21}) {   // 2 mm in the gap
        BendInTime seen = seenAt(tree, frame, 0.01, random);
        auto exact = std::make_shared<DeformableResult>(*seen.bent);
        for (Eigen::Matrix3d& covariance : exact->branches.front().covariance) {
            covariance = 1e-4 * Eigen::Matrix3d::Identity();
        }
        seen.bent = exact;
        bends.push_back(seen);
    }
    EXPECT_LT(errorMm(smoothInTime(tree, bends)), 0.03);
}

TEST(SmoothInTime, LeavesWhatIsTooShortOrOfAnotherTree)
{
    const VesselTree tree = straightTree();
    CounterRandom random(9);
    std::vector<BendInTime> bends{seenAt(tree, 0, noiseMm, random), seenAt(tree, 1, noiseMm, random)};
    EXPECT_EQ(smoothInTime(tree, bends)[1].bent, bends[1].bent);
    bends.push_back(seenAt(tree, 2, noiseMm, random));
    VesselTree other = tree;
    other.branches.front().id = 5;
    EXPECT_EQ(smoothInTime(other, bends)[1].bent, bends[1].bent);
}

}   // namespace
}   // namespace angiopose::core
