#include "core/registration/deformable/smooth_deformations.h"

#include "core/registration/deformable/deformed_tree.h"
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

/// Points that move uniformly to the side, observed with noise.
TimedDeformation seenAt(const VesselTree& tree, int frame, double sizeMm, CounterRandom& random)
{
    auto deformed = std::make_shared<DeformableResult>();
    deformed->cameraFromPatient = poseAt(frame);
    deformed->viewPoses = {poseAt(frame)};
    BranchMotion motion;
    for (std::size_t i = 0; i < tree.branches.front().pointsInPatient.size(); ++i) {
        motion.displacementMm.emplace_back(0.1 * frame + sizeMm * random.normal(), sizeMm * random.normal(),
                                           sizeMm * random.normal());
        motion.covariance.emplace_back(noiseMm * noiseMm * Eigen::Matrix3d::Identity());
    }
    deformed->branches.push_back(motion);
    return {frame, poseAt(frame), deformed};
}

double errorMm(const std::vector<TimedDeformation>& deformations)
{
    double squares = 0.0;
    double count = 0.0;
    for (const TimedDeformation& each : deformations) {
        for (const Eigen::Vector3d& displacement : each.deformed->branches.front().displacementMm) {
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
    std::vector<TimedDeformation> deformations;
    for (int frame = 0; frame < 30; ++frame) {
        deformations.push_back(seenAt(tree, frame, noiseMm, random));
    }
    const std::vector<TimedDeformation> smooth = smoothOverTime(tree, deformations);
    ASSERT_EQ(smooth.size(), deformations.size());
    EXPECT_LT(errorMm(smooth), 0.6 * errorMm(deformations));
    EXPECT_EQ(smooth[3].deformed->branches.front().covariance[5],
              deformations[3].deformed->branches.front().covariance[5]);
}

TEST(SmoothInTime, LeavesFastMotionWhereItIsSeenWell)
{
    const VesselTree tree = straightTree();
    CounterRandom random(8);
    std::vector<TimedDeformation> deformations;
    for (const int frame : {0, 1, 2, 20, 21}) {   // a 2 mm motion in the gap
        TimedDeformation seen = seenAt(tree, frame, 0.01, random);
        auto exact = std::make_shared<DeformableResult>(*seen.deformed);
        for (Eigen::Matrix3d& covariance : exact->branches.front().covariance) {
            covariance = 1e-4 * Eigen::Matrix3d::Identity();
        }
        seen.deformed = exact;
        deformations.push_back(seen);
    }
    EXPECT_LT(errorMm(smoothOverTime(tree, deformations)), 0.03);
}

TEST(SmoothInTime, LeavesWhatIsTooShortOrOfAnotherTree)
{
    const VesselTree tree = straightTree();
    CounterRandom random(9);
    std::vector<TimedDeformation> deformations{seenAt(tree, 0, noiseMm, random), seenAt(tree, 1, noiseMm, random)};
    EXPECT_EQ(smoothOverTime(tree, deformations)[1].deformed, deformations[1].deformed);
    deformations.push_back(seenAt(tree, 2, noiseMm, random));
    VesselTree other = tree;
    other.branches.front().id = 5;
    EXPECT_EQ(smoothOverTime(other, deformations)[1].deformed, deformations[1].deformed);
}

}   // namespace
}   // namespace angiopose::core
