#include "core/tracing/suspect_curves.h"

#include "core/support/quantile.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr double leastShareOfSide = 0.15;
constexpr double evenBendPx = 0.5;   // rms from the best arc, of short curves
constexpr double evenBendPerLength = 0.004;   // and of long ones
constexpr double evenWidth = 0.2;   // spread, and change from one half to the other, relative to the width

/// Points about their mean, one per row.
Eigen::MatrixX2d centred(const std::vector<Eigen::Vector2d>& points)
{
    Eigen::MatrixX2d rows(points.size(), 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        rows.row(static_cast<Eigen::Index>(i)) = points[i];
    }
    rows.rowwise() -= rows.colwise().mean().eval();
    return rows;
}

/// Root mean square distance from the straight line that fits best.
double deviationFromLine(const Eigen::MatrixX2d& points)
{
    const Eigen::Matrix2d spread = points.transpose() * points / static_cast<double>(points.rows());
    return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues()[0]));
}

/// Root mean square distance from the circle that fits best (Kåsa 1976), for points that are not in one line.
double deviationFromArc(const Eigen::MatrixX2d& points)
{
    Eigen::MatrixX3d system(points.rows(), 3);
    system << points, Eigen::VectorXd::Ones(points.rows());
    const Eigen::VectorXd squares = points.rowwise().squaredNorm();
    const Eigen::Vector3d solution = system.colPivHouseholderQr().solve(squares);
    const Eigen::Vector2d centre = 0.5 * solution.head<2>();
    const double radius = std::sqrt(std::max(0.0, solution[2] + centre.squaredNorm()));
    const Eigen::ArrayXd distances = (points.rowwise() - centre.transpose()).rowwise().norm().array();
    return std::sqrt((distances - radius).square().mean());
}

bool bendsEvenly(const Curve2d& curve)
{
    const Eigen::MatrixX2d points = centred(curve.pointsPx);
    const double tolerance = std::max(evenBendPx, evenBendPerLength * curve.lengthPx());
    return deviationFromLine(points) <= tolerance || deviationFromArc(points) <= tolerance;
}

bool keepsItsWidth(const std::vector<double>& radii)
{
    const std::vector<double> spread = quantiles(radii, {0.16, 0.5, 0.84});
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    const double change = quantile({radii.begin(), middle}, 0.5) - quantile({middle, radii.end()}, 0.5);
    return 0.5 * (spread[2] - spread[0]) <= evenWidth * spread[1] && std::abs(change) <= evenWidth * spread[1];
}

}   // namespace

std::vector<int> suspectCurves(const Centerline2d& centerline, int imageSidePx)
{
    std::vector<int> suspects;
    for (const Curve2d& curve : centerline.curves) {
        const bool isLong = curve.pointsPx.size() > 3 && curve.lengthPx() >= leastShareOfSide * imageSidePx;
        const bool hasWidth = curve.radiusPx.size() == curve.pointsPx.size();
        if (isLong && bendsEvenly(curve) && (!hasWidth || keepsItsWidth(curve.radiusPx))) {
            suspects.push_back(curve.id);
        }
    }
    return suspects;
}

}   // namespace core
