#include "core/tracing/angiogram/curves/path_curvature.h"

#include "core/support/symmetric.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// Returns the points relative to their mean, one per row.
Eigen::MatrixX2d centered(const std::vector<Eigen::Vector2d>& points)
{
    Eigen::MatrixX2d rows(points.size(), 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        rows.row(static_cast<Eigen::Index>(i)) = points[i];
    }
    rows.rowwise() -= rows.colwise().mean().eval();
    return rows;
}

}   // namespace

double deviationFromLine(const std::vector<Eigen::Vector2d>& pointsPx)
{
    const Eigen::MatrixX2d points = centered(pointsPx);
    const Eigen::Matrix2d spread = points.transpose() * points / static_cast<double>(points.rows());
    return std::sqrt(std::max(0.0, eigenDecomposition(spread).values[0]));
}

double deviationFromArc(const std::vector<Eigen::Vector2d>& pointsPx)
{
    const Eigen::MatrixX2d points = centered(pointsPx);
    Eigen::MatrixX3d system(points.rows(), 3);
    system << points, Eigen::VectorXd::Ones(points.rows());
    const Eigen::VectorXd squares = points.rowwise().squaredNorm();
    const Eigen::Vector3d solution = system.colPivHouseholderQr().solve(squares);
    const Eigen::Vector2d center = 0.5 * solution.head<2>();
    const double radius = std::sqrt(std::max(0.0, solution[2] + center.squaredNorm()));
    const Eigen::ArrayXd distances = (points.rowwise() - center.transpose()).rowwise().norm().array();
    return std::sqrt((distances - radius).square().mean());
}

}   // namespace angiopose::core
