#include "core/registration/judging/distance_metrics.h"

#include "core/registration/matching/grid_index.h"
#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace angiopose::core {
namespace {

/// Points of concatenated curves; neighboring points of the same curve are joined by a line.
struct CurvePoints {
    const std::vector<Eigen::Vector2d>& points;
    const std::vector<int>& curveIndex;
};

double squaredDistanceToSegment(const Eigen::Vector2d& query, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const Eigen::Vector2d along = to - from;
    const double squaredLength = along.squaredNorm();
    const double share = squaredLength > 0.0 ? std::clamp((query - from).dot(along) / squaredLength, 0.0, 1.0) : 0.0;
    return (query - from - share * along).squaredNorm();
}

/// Returns the distance from `query` to the two segments that meet at the point `nearest`.
double distanceToCurve(const CurvePoints& curves, std::size_t nearest, const Eigen::Vector2d& query)
{
    const Eigen::Vector2d& point = curves.points[nearest];
    const int curve = curves.curveIndex[nearest];
    double squared = (query - point).squaredNorm();
    if (nearest > 0 && curves.curveIndex[nearest - 1] == curve) {
        squared = std::min(squared, squaredDistanceToSegment(query, curves.points[nearest - 1], point));
    }
    if (nearest + 1 < curves.points.size() && curves.curveIndex[nearest + 1] == curve) {
        squared = std::min(squared, squaredDistanceToSegment(query, point, curves.points[nearest + 1]));
    }
    return std::sqrt(squared);
}

double imageDiagonalPx(const ProjectionCamera& camera)
{
    return std::hypot(camera.width, camera.height);
}

double shareBelow(const std::vector<double>& values, double limit)
{
    const auto below = std::count_if(values.begin(), values.end(), [limit](double value) { return value <= limit; });
    return values.empty() ? 0.0 : static_cast<double>(below) / static_cast<double>(values.size());
}

double meanOf(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Returns the distance from every target point to the projected tree.
std::vector<double> reverseDistancesPx(const RegistrationProblem& problem, const ProjectedTree& projected)
{
    std::vector<Eigen::Vector2d> visible;
    std::vector<int> branch;
    for (std::size_t i = 0; i < projected.pointsPx.size(); ++i) {
        if (projected.pointsPx[i].allFinite()) {
            visible.push_back(projected.pointsPx[i]);
            branch.push_back(problem.tree.branchIndex[i]);
        }
    }
    if (visible.empty()) {
        return std::vector<double>(problem.target.size(), imageDiagonalPx(problem.camera));
    }
    const GridIndex index(std::move(visible));
    std::size_t nearest = 0;
    std::vector<double> distances;
    distances.reserve(problem.target.size());
    for (const Eigen::Vector2d& point : problem.target.points) {
        nearest = index.nearestIndex(point, nearest);   // the previous result is a good guess
        distances.push_back(distanceToCurve({index.points(), branch}, nearest, point));
    }
    return distances;
}

}   // namespace

ProjectedTree projectTree(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient,
                          const GridIndex& target)
{
    const std::size_t count = problem.tree.size();
    ProjectedTree projected;
    projected.pointsPx.assign(count, Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()));
    projected.distancePx.assign(count, imageDiagonalPx(problem.camera));
    projected.isInView.assign(count, 0);
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto pixel = project(problem.camera, cameraFromPatient * problem.tree.points[i]);
        if (!pixel) {
            continue;
        }
        nearest = target.nearestIndex(*pixel, nearest);   // the previous result is a good guess
        projected.pointsPx[i] = *pixel;
        projected.distancePx[i] = distanceToCurve({target.points(), problem.target.curveIndex}, nearest, *pixel);
        projected.isInView[i] = pixel->x() >= -0.5 && pixel->y() >= -0.5 && pixel->x() <= problem.camera.width - 0.5 &&
                                pixel->y() <= problem.camera.height - 0.5;
    }
    return projected;
}

DistanceMetrics distanceMetrics(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient,
                                const ProjectedTree& projected)
{
    const double depthMm = std::max(minProjectableDepthMm, (cameraFromPatient * problem.tree.centroid).z());
    const double mmPerPx = millimetersPerPixel(problem.camera, depthMm);
    const std::vector<double> shares = quantiles(projected.distancePx, {0.5, 0.75, 0.95});
    const std::vector<double> reverse = reverseDistancesPx(problem, projected);

    DistanceMetrics metrics;
    metrics.meanPx = meanOf(projected.distancePx);
    metrics.medianPx = shares[0];
    metrics.p75Px = shares[1];
    metrics.p95Px = shares[2];
    metrics.meanMm = metrics.meanPx * mmPerPx;
    metrics.medianMm = metrics.medianPx * mmPerPx;
    metrics.p75Mm = metrics.p75Px * mmPerPx;
    metrics.p95Mm = metrics.p95Px * mmPerPx;
    metrics.coverage = shareBelow(reverse, matchTolerancePx);
    metrics.reverseMeanPx = meanOf(reverse);
    metrics.reverseMeanMm = metrics.reverseMeanPx * mmPerPx;
    return metrics;
}

std::vector<BranchResidual> branchResiduals(const TreeSamples& tree, const ProjectedTree& projected)
{
    std::vector<std::vector<double>> distances(tree.branchIds.size());
    for (std::size_t i = 0; i < tree.size(); ++i) {
        distances[static_cast<std::size_t>(tree.branchIndex[i])].push_back(projected.distancePx[i]);
    }
    std::vector<BranchResidual> residuals;
    for (std::size_t b = 0; b < distances.size(); ++b) {
        const std::vector<double> shares = quantiles(distances[b], {0.5, 0.95});
        residuals.push_back({tree.branchIds[b], static_cast<int>(distances[b].size()), shares[0], shares[1],
                             shareBelow(distances[b], matchTolerancePx)});
    }
    return residuals;
}

}   // namespace angiopose::core
