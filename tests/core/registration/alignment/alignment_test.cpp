#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/alignment_points.h"

#include "tests/support/clean_case.h"

#include "core/geometry/camera_uncertainty.h"

#include <gtest/gtest.h>
#include <array>
#include <numbers>

namespace angiopose::core {
namespace {

/// A case without noise as the inner loop uses it, at a pose slightly off the truth.
struct AlignmentTest : ::testing::Test {
    AlignmentTest()
        : problem(makeProblem(clean.from(clean.truth), {}).value()),
          target(problem.target, problem.camera),
          alignment(alignmentPoints(problem.tree), problem.camera, target),
          truth(aboutCentroid(clean.truth, problem.tree.centroid))
    {
        Vector6d step;
        step << 0.004, -0.003, 0.005, 0.4, -0.3, 2.0;
        beside = retract(truth, step);
    }

    test::CleanCase clean{3};
    RegistrationProblem problem;
    TargetLines target;
    Alignment alignment;
    CentroidPose truth;
    CentroidPose beside;
};

TEST_F(AlignmentTest, GradientsMatchDifferencesOfResiduals)
{
    constexpr double scalePx = 5.0;
    constexpr double h = 1e-6;
    std::vector<ResidualRow> rows;
    std::vector<ResidualRow> ahead;
    std::vector<ResidualRow> behind;
    alignment.collectRows(beside, scalePx, rows);
    int compared = 0;
    for (int k = 0; k < 6; ++k) {
        const Vector6d step = h * Vector6d::Unit(k);
        alignment.collectRows(retract(beside, step), scalePx, ahead);
        alignment.collectRows(retract(beside, -step), scalePx, behind);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double difference = (ahead[i].residual - behind[i].residual) / (2.0 * h);
            // There is no derivative where the nearest line changes within the step.
            const bool isSmooth = std::abs(ahead[i].residual - behind[i].residual) < 1e-2;
            if (rows[i].weight > 0.0 && ahead[i].weight > 0.0 && behind[i].weight > 0.0 && isSmooth) {
                EXPECT_NEAR(rows[i].gradient[k], difference, 1e-5 * std::max(1.0, std::abs(difference)));
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 5000);
}

TEST_F(AlignmentTest, CameraGradientsMatchDifferencesOfResiduals)
{
    constexpr double scalePx = 5.0;
    const std::array<double, 3> steps{1e-7, 1e-4, 1e-4};
    std::vector<ResidualRow> rows;
    std::vector<ResidualRow> ahead;
    std::vector<ResidualRow> behind;
    alignment.collectRows(beside, scalePx, rows);
    int compared = 0;
    for (int k = 0; k < 3; ++k) {
        const double h = steps[static_cast<std::size_t>(k)];
        const CameraError error = h * CameraError::Unit(k);
        const auto points = alignmentPoints(problem.tree);
        Alignment(points, applyCameraError(problem.camera, error), target).collectRows(beside, scalePx, ahead);
        Alignment(points, applyCameraError(problem.camera, -error), target).collectRows(beside, scalePx, behind);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double difference = (ahead[i].residual - behind[i].residual) / (2.0 * h);
            const bool isSmooth = std::abs(ahead[i].residual - behind[i].residual) < 1e-2;
            if (rows[i].weight > 0.0 && ahead[i].weight > 0.0 && behind[i].weight > 0.0 && isSmooth) {
                EXPECT_NEAR(rows[i].cameraGradient[k], difference, 1e-4 * std::max(1.0, std::abs(difference)));
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 2500);
}

TEST_F(AlignmentTest, LinesDrawnToTheTreePullItBack)
{
    // Isolates the contribution of the lines: subtracts the tree's own points from the sum of both directions.
    AlignmentEvaluation both;
    CentroidPose pose = beside;
    for (int k = 0; k < 4; ++k) {
        alignment.searchBothDirections(pose, 5.0, both);
        NormalEquations reverse = alignment.evaluate(pose, 5.0).equations;
        reverse.hessian = both.equations.hessian - reverse.hessian;
        reverse.gradient = both.equations.gradient - reverse.gradient;
        pose = retract(pose, dampedStep(reverse, 1e-6));
    }
    EXPECT_LT(stepBetween(truth, pose).head<3>().norm(), 0.1 * stepBetween(truth, beside).head<3>().norm());
    EXPECT_LT(stepBetween(truth, pose).segment<2>(3).norm(), 0.1 * stepBetween(truth, beside).segment<2>(3).norm());
}

TEST_F(AlignmentTest, LinesKeepTheirPartnersWhileThePointsHardlyMove)
{
    Vector6d step = Vector6d::Zero();
    step[3] = 0.2 * millimetersPerPixel(clean.camera, beside.centroidInCamera.z());
    const CentroidPose near = retract(beside, step);
    Alignment fresh = alignment;
    AlignmentEvaluation kept;
    AlignmentEvaluation again;
    alignment.searchBothDirections(beside, 3.0, kept);
    const std::vector<int> matches = alignment.buffers().reverse.matches();
    alignment.searchBothDirections(near, 3.0, kept);
    fresh.searchBothDirections(near, 3.0, again);
    EXPECT_EQ(alignment.buffers().reverse.matches(), matches);
    EXPECT_NE(fresh.buffers().reverse.matches(), matches);
    // Perpendicular to the branches, both agree.
    EXPECT_NEAR(kept.loss, again.loss, 0.01 * std::abs(again.loss));
    const Vector6d keptStep = dampedStep(kept.equations, 1e-6);
    const Vector6d freshStep = dampedStep(again.equations, 1e-6);
    EXPECT_LT((keptStep - freshStep).norm(), 0.02 * freshStep.norm());
    // After a longer step, or with a different reach, correspondences are searched again.
    alignment.searchBothDirections(truth, 3.0, kept);
    fresh.searchBothDirections(truth, 3.0, again);
    EXPECT_EQ(alignment.buffers().reverse.matches(), fresh.buffers().reverse.matches());
    EXPECT_EQ(kept.loss, again.loss);
}

TEST_F(AlignmentTest, NearestProjectedPointIsFoundWithinReachOnly)
{
    ProjectedPoints points;
    points.reset(100, 60, 6.0);
    points.add({50.0, 30.0, 7});
    points.add({57.0, 30.0, 8});
    points.add({-5.0, 30.0, 9});
    ASSERT_NE(points.nearest(52.0, 31.0), nullptr);
    EXPECT_EQ(points.nearest(52.0, 31.0)->number, 7);
    EXPECT_EQ(points.nearest(55.0, 31.0)->number, 8);
    EXPECT_EQ(points.nearest(50.0, 37.0), nullptr);
    EXPECT_EQ(points.nearest(-3.0, 30.0), nullptr);
    EXPECT_EQ(points.nearest(500.0, -300.0), nullptr);
    points.reset(100, 60, 6.0);
    EXPECT_EQ(points.nearest(50.0, 30.0), nullptr);
}

TEST_F(AlignmentTest, LookSumsUpTheRows)
{
    std::vector<ResidualRow> rows;
    alignment.collectRows(beside, 3.0, rows);
    NormalEquations sum;
    for (const ResidualRow& row : rows) {
        sum.hessian += row.weight * row.gradient * row.gradient.transpose();
        sum.gradient += row.weight * row.residual * row.gradient;
    }
    const NormalEquations looked = alignment.evaluate(beside, 3.0).equations;
    const Matrix6d full = looked.hessian.selfadjointView<Eigen::Lower>();
    EXPECT_LT((full - sum.hessian).norm(), 1e-9 * sum.hessian.norm());
    EXPECT_LT((looked.gradient - sum.gradient).norm(), 1e-9 * sum.gradient.norm());
}

TEST_F(AlignmentTest, LeavingTheViewIsNeverCheaper)
{
    const double beforeLoss = alignment.evaluate(beside, 3.0).loss;
    const double maxLoss = 2.0 * 3.0 * 3.0 * static_cast<double>(alignment.size());
    for (const double shiftMm : {100.0, 400.0, 2000.0}) {
        CentroidPose away = beside;
        away.centroidInCamera.x() += shiftMm;
        EXPECT_GT(alignment.evaluate(away, 3.0).loss, beforeLoss);
        EXPECT_LE(alignment.evaluate(away, 3.0).loss, maxLoss * (1.0 + 1e-12));
    }
}

TEST_F(AlignmentTest, GoingBehindTheSourceCostsTheMost)
{
    CentroidPose behind = beside;
    behind.centroidInCamera.z() = -800.0;
    EXPECT_DOUBLE_EQ(alignment.evaluate(behind, 3.0).loss, 2.0 * 3.0 * 3.0 * static_cast<double>(alignment.size()));
    EXPECT_EQ(alignment.evaluate(behind, 3.0).equations.hessian, Matrix6d::Zero());
}

TEST_F(AlignmentTest, TheLossAloneIsTheLossOfALook)
{
    for (const double scalePx : {1.0, 5.0}) {
        const AlignmentEvaluation look = alignment.evaluate(beside, scalePx);
        EXPECT_NEAR(alignment.loss(beside, scalePx), look.loss, 1e-9 * look.loss);
        alignment.setVisibility(look);
    }
}

TEST_F(AlignmentTest, VesselsAcrossTheTreeDoNotPull)
{
    // The whole tree rolled by a right angle: any vessel it still touches by chance, it crosses.
    Vector6d roll = Vector6d::Zero();
    roll[2] = std::numbers::pi / 2.0;
    const double along = alignment.evaluate(truth, 1.0).equations.hessian.trace();
    EXPECT_LT(alignment.evaluate(retract(truth, roll), 1.0).equations.hessian.trace(), 0.1 * along);
}

}   // namespace
}   // namespace angiopose::core
