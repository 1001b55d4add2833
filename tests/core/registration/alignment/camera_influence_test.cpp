#include "core/registration/alignment/camera_influence.h"

#include "core/messages/messages.h"
#include "core/support/random.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

namespace angiopose::core {
namespace {

/// Random derivative rows [pose | camera] of a synthetic view, more rows than parameters.
Eigen::MatrixXd derivatives()
{
    CounterRandom random(7);
    Eigen::MatrixXd rows(40, 9);
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
        rows(i) = random.normal();
    }
    return rows;
}

/// Normal equations of the residuals left by a camera error while pose and camera keep their assumed values: 0 = r + J
/// x.
StackedEquations equationsFor(const CameraError& error)
{
    const Eigen::MatrixXd J = derivatives();
    const Eigen::VectorXd residuals = -J.rightCols(3) * error;
    return {J.transpose() * J, J.transpose() * residuals};
}

const CameraUncertainty wideSpread{100.0, 100.0};

TEST(CameraInfluence, FindsTheErrorThatLeftTheResiduals)
{
    const CameraError error(0.05, 20.0, -7.0);
    const CameraInfluence influence(equationsFor(error), Matrix6d::Identity(), {&wideSpread, 1});
    EXPECT_LT((influence.evidence(0).error - error).norm(), 1e-2 * error.norm());
    EXPECT_GT(influence.evidence(0).gain, 100.0);
}

TEST(CameraInfluence, APriorHoldsWhatTheImagesDoNotTell)
{
    StackedEquations nothing{1e-9 * Eigen::MatrixXd::Identity(9, 9), Eigen::VectorXd::Zero(9)};
    const CameraUncertainty spread{0.03, 10.0};
    const CameraInfluence influence(nothing, Matrix6d::Identity(), {&spread, 1});
    EXPECT_NEAR(influence.evidence(0).std[0], 0.03, 1e-6);
    EXPECT_NEAR(influence.evidence(0).std[2], 10.0, 1e-6);
    EXPECT_EQ(influence.evidence(0).gain, 0.0);
}

// The part of the focal length that the images do not determine moves the pose exactly as solving the rows for it does.
TEST(CameraInfluence, AddsToThePoseWhatTheErrorDoesToIt)
{
    const Eigen::MatrixXd J = derivatives();
    const CameraUncertainty onlyFocal{1e-4, 0.0};   // far below the information in the rows, so all of it remains
    const CameraInfluence influence(equationsFor(CameraError::Zero()), Matrix6d::Identity(), {&onlyFocal, 1});
    const Matrix6d H = J.leftCols(6).transpose() * J.leftCols(6);
    const Vector6d moved = -1e-4 * H.inverse() * J.leftCols(6).transpose() * J.col(6);
    const Matrix6d expected = moved * moved.transpose();
    EXPECT_LT((influence.poseCovariance() - expected).norm(), 1e-3 * expected.norm());
}

TEST(CameraInfluence, AnErrorThatShowsCountsWhole)
{
    const CameraError error(3.0, 0.0, 0.0);
    const CameraInfluence influence(equationsFor(error), Matrix6d::Identity(), {&wideSpread, 1});
    const Eigen::MatrixXd J = derivatives();
    const Matrix6d H = J.leftCols(6).transpose() * J.leftCols(6);
    const Vector6d moved = -H.inverse() * J.leftCols(6).transpose() * J.rightCols(3) * error;
    const CameraInfluence none(equationsFor(CameraError::Zero()), Matrix6d::Identity(), {&wideSpread, 1});
    const Matrix6d added = influence.poseCovariance() - none.poseCovariance();
    EXPECT_LT((added - moved * moved.transpose()).norm(), 0.02 * moved.squaredNorm());
}

TEST(CameraInfluence, LockedStepsStayCertain)
{
    const CameraUncertainty spread{0.03, 10.0};
    const Eigen::MatrixXd allButDepth = Matrix6d::Identity().leftCols(5);
    const CameraInfluence influence(equationsFor(CameraError::Zero()), allButDepth, {&spread, 1});
    EXPECT_NEAR(influence.poseCovariance()(5, 5), 0.0, 1e-12);
    EXPECT_GT(influence.poseCovariance()(4, 4), 0.0);
}

TEST(CameraContradiction, NamesWhatIsOffAndByHowMuch)
{
    const ProjectionCamera camera{-2500.0, 2500.0, 511.5, 511.5, 1024, 1024};
    const Messages focal = contradictionsOf({{0.05, 1.0, 0.0}, {0.005, 5.0, 5.0}, 80.0}, camera);
    ASSERT_EQ(focal.size(), 1U);
    EXPECT_TRUE(focal.front().is(messages::cameraFocalLonger));
    EXPECT_NE(focal.front().text().find("5.1 %"), std::string::npos);
    const Messages point = contradictionsOf({{0.0, 20.0, 0.0}, {0.005, 3.0, 3.0}, 80.0}, camera);
    ASSERT_EQ(point.size(), 1U);
    EXPECT_TRUE(point.front().is(messages::cameraPrincipalPointOff));
    EXPECT_NE(point.front().text().find("(532, 512)"), std::string::npos);
    EXPECT_TRUE(contradictionsOf({{0.05, 20.0, 0.0}, {0.02, 8.0, 8.0}, 8.0}, camera).empty());
}

}   // namespace
}   // namespace angiopose::core
