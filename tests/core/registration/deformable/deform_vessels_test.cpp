#include "core/registration/deformable/deform_vessels.h"

#include "core/registration/deformable/deformed_tree.h"

#include "core/messages/messages.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>

namespace angiopose::core {
namespace {

using Motion = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// A tree of 24 branches that moved since its scan, in one view or with a second view turned by 70°.
struct MovedTree {
    explicit MovedTree(const Motion& motion) : moved(clean.tree)
    {
        for (VesselBranch& branch : moved.branches) {
            for (Eigen::Vector3d& point : branch.pointsInPatient) {
                point += motion(point);
            }
        }
    }

    DeformableView view(double turnDeg = 0.0) const
    {
        const RigidTransform pose = poseAt(turnDeg);
        DeformableView view{clean.from(pose), pose, 0};
        view.input.target = projectTree(moved, clean.camera, pose);
        return view;
    }

    RigidTransform poseAt(double turnDeg) const
    {
        const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
        RigidTransform pose = clean.truth;
        pose.rotation = expSo3({0.0, turnDeg / 57.3, 0.0}) * clean.truth.rotation;
        pose.translation = clean.truth * centroid - pose.rotation * centroid;
        return pose;
    }

    /// Mean distance of the points from their true positions, in the plane of the first view or in space, mm.
    double errorMm(const DeformableResult& result, bool isInSpace) const
    {
        const VesselTree deformed = deformedTree(clean.tree, result);
        double sum = 0.0;
        for (std::size_t b = 0; b < deformed.branches.size(); ++b) {
            for (std::size_t i = 0; i < deformed.branches[b].pointsInPatient.size(); ++i) {
                const Eigen::Vector3d apart = result.cameraFromPatient * deformed.branches[b].pointsInPatient[i] -
                                              clean.truth * moved.branches[b].pointsInPatient[i];
                sum += isInSpace ? apart.norm() : apart.head<2>().norm();
            }
        }
        return sum / static_cast<double>(deformed.pointCount());
    }

    test::CleanCase clean{3};
    VesselTree moved;
};

Eigen::Vector3d swayed(const Eigen::Vector3d& place)
{
    return {3.0 * std::sin(place.z() / 25.0), 2.0 * std::cos(place.x() / 30.0), 2.0 * std::sin(place.y() / 30.0)};
}

Eigen::Vector3d still(const Eigen::Vector3d&)
{
    return Eigen::Vector3d::Zero();
}

bool says(const DeformableResult& result, const MessageEntry& entry)
{
    return std::ranges::any_of(result.messages, [&](const Message& message) { return message.is(entry); });
}

TEST(DeformVessels, RigidTruthStaysRigid)
{
    const MovedTree tree(still);
    const auto result = deformVessels(std::vector{tree.view()});

    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().verdict, DeformationVerdict::Rigid);
    EXPECT_LT(result.value().logEvidenceGain, 10.0);
    EXPECT_EQ(result.value().largestMotionMm, 0.0);
    EXPECT_EQ(result.value().cameraFromPatient.matrix(), tree.clean.truth.matrix());
    EXPECT_EQ(deformedTree(tree.clean.tree, result.value()).branches[2].pointsInPatient[1],
              tree.clean.tree.branches[2].pointsInPatient[1]);
}

TEST(DeformVessels, RecoversAKnownMotionInThePlaneOfOneView)
{
    const MovedTree tree(swayed);
    const auto result = deformVessels(std::vector{tree.view()});

    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().verdict, DeformationVerdict::Deformed);
    EXPECT_LT(tree.errorMm(result.value(), false), 0.3);
    EXPECT_GT(result.value().largestMotionMm, 2.0);
    EXPECT_TRUE(says(result.value(), messages::deformationDepthUnknown));
}

TEST(DeformVessels, RecoversAKnownMotionInSpaceFromTwoViews)
{
    const MovedTree tree(swayed);
    const auto result = deformVessels(std::vector{tree.view(), tree.view(70.0)});

    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().verdict, DeformationVerdict::Deformed);
    EXPECT_LT(tree.errorMm(result.value(), true), 0.5);
    EXPECT_FALSE(says(result.value(), messages::deformationDepthUnknown));
    ASSERT_EQ(result.value().viewPoses.size(), 2u);
    const RigidTransform between = result.value().viewPoses[1] * result.value().viewPoses[0].inverse();
    EXPECT_TRUE(between.matrix().isApprox((tree.poseAt(70.0) * tree.clean.truth.inverse()).matrix(), 1e-6));
}

TEST(DeformVessels, CovarianceCoversTheErrorsOfThePoints)
{
    const MovedTree tree(swayed);
    const DeformableResult result = deformVessels(std::vector{tree.view()}).value();
    const VesselTree deformed = deformedTree(tree.clean.tree, result);
    double inside = 0.0;
    for (std::size_t b = 0; b < deformed.branches.size(); ++b) {
        ASSERT_EQ(result.branches[b].covariance.size(), deformed.branches[b].pointsInPatient.size());
        for (std::size_t i = 0; i < deformed.branches[b].pointsInPatient.size(); ++i) {
            const Eigen::Vector2d e = (result.cameraFromPatient * deformed.branches[b].pointsInPatient[i] -
                                       tree.clean.truth * tree.moved.branches[b].pointsInPatient[i])
                                          .head<2>();
            const Eigen::Matrix2d covariance = result.branches[b].covariance[i].topLeftCorner<2, 2>();
            inside += e.dot(covariance.inverse() * e) < 5.991 ? 1.0 : 0.0;
        }
    }
    EXPECT_GT(inside / static_cast<double>(deformed.pointCount()), 0.85);
}

TEST(DeformVessels, SaysInWordsThatOneHalfIsOff)
{
    // A motion across the ray of all points below the centroid, blended over 2 mm.
    const test::CleanCase clean(3);
    const double middle = centroidInPatient(clean.tree).z();
    const Eigen::Vector3d aside = clean.truth.rotation.transpose() * Eigen::Vector3d::UnitX();
    const MovedTree tree([&](const Eigen::Vector3d& place) {
        return Eigen::Vector3d(8.0 / (1.0 + std::exp((place.z() - middle) / 2.0)) * aside);
    });
    const auto result = deformVessels(std::vector{tree.view()});

    ASSERT_TRUE(result);
    EXPECT_NE(result.value().verdict, DeformationVerdict::Rigid);
    const auto reported = std::ranges::find_if(
        result.value().messages, [](const Message& message) { return message.is(messages::deformationPartMoved); });
    ASSERT_NE(reported, result.value().messages.end());
    const auto shift = std::get<Quantity>(reported->arguments()[2]);
    EXPECT_NEAR(shift.value, 8.0, 3.0) << reported->text();
}

TEST(DeformVessels, StopKeepsTheRigidPose)
{
    const MovedTree tree(swayed);
    int reported = 0;
    double progress = 0.0;
    const auto result = deformVessels(std::vector{tree.view()}, {}, [&](const IterationReport& report) {
        EXPECT_EQ(report.stage, "bending");
        EXPECT_GE(report.progress, progress);
        progress = report.progress;
        return ++reported == 5 ? ObserverDecision::Stop : ObserverDecision::Continue;
    });

    ASSERT_TRUE(result);
    EXPECT_EQ(reported, 5);
    EXPECT_EQ(result.value().stopReason, StopReason::StoppedByUser);
    EXPECT_EQ(result.value().verdict, DeformationVerdict::Unsure);
    EXPECT_TRUE(says(result.value(), messages::deformationStopped));
    EXPECT_EQ(result.value().cameraFromPatient.matrix(), tree.clean.truth.matrix());
    EXPECT_EQ(result.value().branches.size(), tree.clean.tree.branches.size());
}

TEST(DeformVessels, TheSameInputGivesTheSameBits)
{
    const MovedTree tree(swayed);
    const DeformableResult once = deformVessels(std::vector{tree.view()}).value();
    const DeformableResult again = deformVessels(std::vector{tree.view()}).value();

    EXPECT_EQ(once.logEvidenceGain, again.logEvidenceGain);
    for (std::size_t b = 0; b < once.branches.size(); ++b) {
        EXPECT_EQ(once.branches[b].displacementMm, again.branches[b].displacementMm);
    }
}

TEST(DeformVessels, ExcludedBranchesAreMovedButLookAtNothing)
{
    const MovedTree tree(swayed);
    DeformableView view = tree.view();
    view.input.excludedBranchIds = {view.input.tree.branches[4].id};
    const DeformableResult result = deformVessels(std::vector{view}).value();

    EXPECT_EQ(result.branches[4].seenShare, 0.0);
    EXPECT_GT(result.branches[4].displacementMm.front().norm(), 0.1);
    EXPECT_GT(result.branches[0].seenShare, 0.5);
}

TEST(DeformVessels, RefusesWhatItCannotUse)
{
    const MovedTree tree(still);
    const auto refused = [](const std::vector<DeformableView>& views, const MessageEntry& entry,
                            const DeformableOptions& options = {}) {
        const auto result = deformVessels(views, options);
        ASSERT_FALSE(result);
        EXPECT_TRUE(result.error().message.is(entry)) << result.error().message;
    };
    refused({}, messages::deformationNoView);

    DeformableView points = tree.view();
    points.input.target.curves.clear();
    for (int k = 0; k < 4; ++k) {   // too far apart to be points of one curve
        points.input.target.curves.push_back({k, {{20.0 + 400.0 * (k % 2), 20.0 + 400.0 * (k / 2)}}, {}});
    }
    refused({points}, messages::deformationNeedsCurves);

    DeformableView skewed = tree.view();
    skewed.rigidCameraFromPatient.rotation(0, 0) += 0.5;
    refused({skewed}, messages::initialPoseNotRigid);

    DeformableView other = tree.view(70.0);
    other.input.tree.branches.pop_back();
    refused({tree.view(), other}, messages::viewsOfOtherTree);

    refused({tree.view()}, messages::deformationOptionsUnusable, {.posePriorDeg = 0.0});
}

TEST(DeformVessels, NothingSeenStaysRigid)
{
    const MovedTree tree(still);
    DeformableView view = tree.view();
    view.input.target.curves = {{0, {{-500.0, -500.0}, {-490.0, -500.0}, {-480.0, -500.0}}, {}}};
    const auto result = deformVessels(std::vector{view});

    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().verdict, DeformationVerdict::Rigid);
    EXPECT_EQ(result.value().cameraFromPatient.matrix(), tree.clean.truth.matrix());
}

}   // namespace
}   // namespace angiopose::core
