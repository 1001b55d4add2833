#include "core/registration/judging/pose_uncertainty.h"

#include "core/simulation/degrade_target.h"
#include "core/simulation/phantom.h"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <cmath>

namespace angiopose::core {
namespace {

/// Mean 1-σ of the depth at the true pose over several degraded images, for a tree of `points` points.
double depthStdWith(int points)
{
    constexpr std::uint64_t images = 6;
    const Phantom shown = makePhantom(1000, 2000);
    RegistrationOptions options;
    options.resample = false;
    RegistrationInput input;
    input.tree = makePhantom(1000, points).tree;
    input.camera = shown.camera;
    input.initialCameraFromPatient = shown.trueCameraFromPatient;
    double sum = 0.0;
    for (std::uint64_t image = 0; image < images; ++image) {
        input.target = addTracingErrors(shown.exactTarget, shown.camera, CounterRandom(image));
        const RegistrationProblem problem = makeProblem(input, options).value();
        const InitialPosePrior prior = initialPosePrior(aboutCentroid(problem.start, problem.tree.centroid), options);
        const TargetLines lines(problem.target, problem.camera);
        sum += estimateUncertainty(problem, lines, problem.start, prior).uncertainty.depthMm / images;
    }
    return sum;
}

// Points closer than the image sampling add no information. Counted as independent, 50 times as many points make the
// depth look three times as certain while the errors stay the same.
TEST(PoseUncertainty, DoesNotShrinkWithPointsThatTellNothingNew)
{
    const double usual = depthStdWith(2000);
    EXPECT_NEAR(depthStdWith(100000), usual, 0.15 * usual);
}

// The centroid in result.json is that of the whole vessel tree, whichever points the registration uses.
TEST(PoseUncertainty, IsAboutTheCentroidOfTheWholeTree)
{
    const Phantom shown = makePhantom(1000, 2000);
    RegistrationInput input;
    input.tree = shown.tree;
    input.target = addTracingErrors(shown.exactTarget, shown.camera, CounterRandom(3));
    input.camera = shown.camera;
    input.initialCameraFromPatient = shown.trueCameraFromPatient;
    const auto branchCount = static_cast<int>(shown.tree.branches.size());
    for (int k = branchCount / 2; k < branchCount; ++k) {
        input.excludedBranchIds.push_back(shown.tree.branches[static_cast<std::size_t>(k)].id);
    }
    const RegistrationProblem problem = makeProblem(input, {}).value();
    const Eigen::Vector3d arm = problem.start.rotation * (centroidInPatient(shown.tree) - problem.tree.centroid);
    ASSERT_GT(arm.norm(), 1.0);

    const TargetLines lines(problem.target, problem.camera);
    const CentroidPose pose = aboutCentroid(problem.start, problem.tree.centroid);
    const InitialPosePrior prior = initialPosePrior(pose, {});
    const Matrix6d aboutUsed = poseInformation(problem, lines, pose, prior).inverse();
    Eigen::Matrix<double, 3, 6>
        motion;   // Jacobian from steps about the centroid of the used points to steps about that of the whole tree
    motion << -skew(arm), Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d expected = motion * aboutUsed * motion.transpose();
    const PoseUncertainty reported = estimateUncertainty(problem, lines, problem.start, prior).uncertainty;
    EXPECT_LT((reported.covariance.bottomRightCorner<3, 3>() - expected).norm(), 1e-6 * expected.norm());
    EXPECT_NEAR(reported.depthMm, std::sqrt(expected(2, 2)), 1e-6);
    const Matrix6d difference = reported.covariance - aboutUsed;   // rotations are the same about any pivot
    EXPECT_LT((difference.topLeftCorner<3, 3>().norm()), (1e-6 * aboutUsed.topLeftCorner<3, 3>().norm()));
}

}   // namespace
}   // namespace angiopose::core
