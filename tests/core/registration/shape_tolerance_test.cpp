#include "core/registration/shape_tolerance.h"

#include "core/support/random.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace core {
namespace {

/// Rows of `branches` straight branches whose residuals are `offset(branch)` plus white noise.
template <class Offset>
std::vector<ResidualRow> rowsWith(int branches, double noisePx, Offset offset)
{
    CounterRandom random(3);
    std::vector<ResidualRow> rows;
    for (int branch = 0; branch < branches; ++branch) {
        Vector6d direction;
        for (double& value : direction) {
            value = random.normal();
        }
        for (int i = 0; i < 60; ++i) {
            ResidualRow row;
            row.branchIndex = branch;
            row.weight = 1.0;
            row.gradient = direction + 0.3 * std::sin(0.2 * i) * Vector6d::Ones();
            row.residual = offset(branch) + noisePx * random.normal();
            rows.push_back(row);
        }
    }
    return rows;
}

TEST(ShapeTolerance, TrustsAShapeWithoutOffsets)
{
    const auto rows = rowsWith(12, 0.2, [](int) { return 0.0; });
    EXPECT_EQ(shapeErrors(rows).varianceRatio(), 0.0);
}

TEST(ShapeTolerance, NoticesBranchesThatAreOff)
{
    const auto rows = rowsWith(12, 0.3, [](int branch) { return branch % 2 == 0 ? 0.6 : -0.6; });
    EXPECT_NEAR(shapeErrors(rows).varianceRatio(), 0.36 / 0.09 * 1.4826 * 1.4826, 3.0);
}

TEST(ShapeTolerance, KeepsInformationPositiveAndBelowThatOfAnExactShape)
{
    const auto rows = rowsWith(12, 0.3, [](int) { return 0.0; });
    const Matrix6d exact = tolerantEquations(rows, 1e-12).hessian;
    const Matrix6d tolerant = tolerantEquations(rows, 4.0).hessian;
    EXPECT_GT(tolerant.eigenvalues().real().minCoeff(), 0.0);
    EXPECT_GT((exact - tolerant).eigenvalues().real().minCoeff(), -1e-6 * exact.norm());
}

}   // namespace
}   // namespace core
