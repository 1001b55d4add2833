#include "core/registration/alignment/shape_tolerance.h"

#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/shape_field.h"
#include "core/support/random.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

/// Rows of straight branches in space, deformed sideways by a smooth field of about `offsetPx`, plus white noise of 0.2
/// px.
std::vector<ResidualRow> deformedRows(double offsetPx, std::uint64_t seed)
{
    CounterRandom random(seed);
    std::vector<ResidualRow> rows;
    for (int branch = 0; branch < 20; ++branch) {
        const Eigen::Vector3d from(random.uniform(-80.0, 80.0), random.uniform(-80.0, 80.0), 0.0);
        const double angle = random.uniform(0.0, std::numbers::pi);
        const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0.0);
        Vector6d tilt;   // perspective: every branch carries some information on all directions
        for (double& value : tilt) {
            value = random.normal();
        }
        const double deformation =
            offsetPx * random.normal();   // branches are mostly farther apart than the correlation length of the field
        for (int i = 0; i < 30; ++i) {
            ResidualRow row;
            row.branchIndex = branch;
            row.weight = 1.0;
            row.fromCentroid = from + i * along + Eigen::Vector3d(0.0, 0.0, 200.0 * branch);
            const Eigen::Vector3d normal(-along.y(), along.x(), 0.0);
            row.gradient << row.fromCentroid.cross(normal), normal;
            row.gradient += 0.1 * tilt;
            row.residual = deformation + 0.2 * random.normal();
            rows.push_back(row);
        }
    }
    return rows;
}

TEST(ShapeField, WithoutDeformationCountsTheRowsAlone)
{
    const auto rows = deformedRows(0.0, 1);
    ShapeField field(rows, 0.04);
    Matrix6d sum = Matrix6d::Zero();
    for (const ResidualRow& row : rows) {
        sum += row.gradient * row.gradient.transpose() / 0.04;
    }
    EXPECT_LT((field.equations(0.0).hessian - sum).norm(), 1e-9 * sum.norm());
}

TEST(ShapeField, LeavesInformationPositiveAndBelowThatOfAnExactShape)
{
    const auto rows = deformedRows(1.0, 2);
    ShapeField field(rows, 0.04);
    const Matrix6d exact = field.equations(0.0).hessian;
    const Matrix6d tolerant = field.equations(1.0).hessian;
    EXPECT_GT(tolerant.eigenvalues().real().minCoeff(), 0.0);
    EXPECT_GT((exact - tolerant).eigenvalues().real().minCoeff(), -1e-6 * exact.norm());
}

TEST(ShapeField, FindsHowMuchTheVesselsAreDeformed)
{
    NormalEquations prior;
    prior.hessian = 1e-6 * Matrix6d::Identity();
    for (const double offsetPx : {0.5, 2.0}) {
        double sum = 0.0;
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            sum += ShapeField(deformedRows(offsetPx, seed), 0.04).estimateOffsetPx(prior) / 10.0;
        }
        EXPECT_NEAR(sum, offsetPx, 0.35 * offsetPx);
    }
}

TEST(ShapeTolerance, KeepsThePoseOfAnExactShape)
{
    const test::CleanCase clean(1);
    const RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
    const TargetLines target(problem.target, problem.camera);
    const Alignment alignment(alignmentPoints(problem.tree), problem.camera, target);
    const CentroidPose truth = aboutCentroid(clean.truth, problem.tree.centroid);
    const CentroidPose refined = refineWithShapeErrors(alignment, initialPosePrior(truth, {}), truth, 1.0);
    EXPECT_LT(stepBetween(truth, refined).norm(), 1e-12);
}

}   // namespace
}   // namespace angiopose::core
