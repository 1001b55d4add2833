#include "core/registration/vessel_tracker.h"

#include "core/registration/deformable/deformed_tree.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <cmath>
#include <span>

namespace angiopose::core {
namespace {

/// A run in which the vessels sway back and forth with respiration.
struct SwayingRun {
    VesselTree treeAt(int frame) const
    {
        const double phase = 0.2 * frame;
        VesselTree tree = clean.tree;
        for (VesselBranch& branch : tree.branches) {
            for (Eigen::Vector3d& point : branch.pointsInPatient) {
                point += std::cos(phase) * Eigen::Vector3d(3.0 * std::sin(point.z() / 25.0), 0.0, 0.0) +
                         std::sin(phase) * Eigen::Vector3d(0.0, 2.0 * std::cos(point.x() / 30.0), 0.0);
            }
        }
        return tree;
    }

    RigidTransform poseAt(int frame) const
    {
        RigidTransform pose = clean.truth;
        pose.translation.y() += 4.0 * (1.0 - std::cos(0.2 * frame));
        return pose;
    }

    RegistrationInput inputAt(int frame) const
    {
        RegistrationInput input = clean.from(poseAt(frame));
        input.target = projectTree(treeAt(frame), clean.camera, poseAt(frame));
        return input;
    }

    std::shared_ptr<const DeformableResult> firstDeformation() const
    {
        const DeformableView view{inputAt(0), poseAt(0), 0};
        return std::make_shared<const DeformableResult>(deformVessels(std::span(&view, 1)).value());
    }

    /// Mean distance across the rays from the true vessel positions, mm.
    double errorMm(const VesselTree& found, const RigidTransform& pose, int frame) const
    {
        const VesselTree truth = treeAt(frame);
        double sum = 0.0;
        for (std::size_t b = 0; b < found.branches.size(); ++b) {
            for (std::size_t i = 0; i < found.branches[b].pointsInPatient.size(); ++i) {
                const Eigen::Vector3d there = pose * found.branches[b].pointsInPatient[i];
                const Eigen::Vector3d wanted = poseAt(frame) * truth.branches[b].pointsInPatient[i];
                sum += (wanted.z() / there.z() * there.head<2>() - wanted.head<2>()).norm();
            }
        }
        return sum / static_cast<double>(found.pointCount());
    }

    test::CleanCase clean{3};
};

TEST(VesselTracker, FollowsHowVesselsDeformation)
{
    const SwayingRun run;
    auto follower = VesselTracker::from(run.inputAt(0), run.firstDeformation(), {});
    ASSERT_TRUE(follower);
    VesselTracker deformed = std::move(follower).value();
    VesselTracker rigid = VesselTracker::from(run.inputAt(0), nullptr, {}).value();
    double deformedMm = 0.0;
    double rigidMm = 0.0;
    for (int frame = 1; frame <= 20; ++frame) {
        const auto found = deformed.next(run.inputAt(frame).target);
        ASSERT_TRUE(found);
        EXPECT_TRUE(found.value().tracked.isTrustworthy) << frame;
        ASSERT_TRUE(found.value().deformed) << frame;
        const RigidTransform& pose = found.value().tracked.cameraFromPatient;
        deformedMm += run.errorMm(deformedTreeAt(run.clean.tree, *found.value().deformed, pose), pose, frame) / 20.0;
        const RigidTransform rigidPose = rigid.next(run.inputAt(frame).target).value().tracked.cameraFromPatient;
        rigidMm += run.errorMm(run.clean.tree, rigidPose, frame) / 20.0;
    }
    EXPECT_LT(deformedMm, 0.3);
    EXPECT_LT(deformedMm, 0.25 * rigidMm);
}

TEST(VesselTracker, FollowsRigidVesselsWithoutABend)
{
    const SwayingRun run;
    VesselTracker follower = VesselTracker::from(run.inputAt(0), nullptr, {}).value();
    const auto found = follower.next(run.inputAt(1).target);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found.value().deformed);
}

TEST(VesselTracker, StaysAsItWasAtAFrameWithoutVessels)
{
    const SwayingRun run;
    VesselTracker follower = VesselTracker::from(run.inputAt(0), run.firstDeformation(), {}).value();
    EXPECT_FALSE(follower.next({}));
    const auto found = follower.next(run.inputAt(1).target);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found.value().deformed);
}

TEST(VesselTracker, TakesNoDeformationOfAnotherTree)
{
    const SwayingRun run;
    RegistrationInput other = run.inputAt(0);
    other.tree.branches.pop_back();
    VesselTracker follower = VesselTracker::from(other, run.firstDeformation(), {}).value();
    EXPECT_FALSE(follower.next(run.inputAt(1).target).value().deformed);
}

}   // namespace
}   // namespace angiopose::core
