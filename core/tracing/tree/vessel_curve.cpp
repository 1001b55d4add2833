#include "core/tracing/tree/vessel_curve.h"

#include "core/support/quantile.h"
#include "core/vessel/polyline.h"
#include "core/vessel/smoothing_spline.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int centeringRounds = 3;
constexpr double initialStiffness = 4.0;   ///< λ of the first smoothing, which only removes voxel stair steps
constexpr double firmWeight = 50.0;
constexpr int maxPullBackRounds = 3;
constexpr double minOpacificationOfPath = 0.5;   ///< relative to the original path; lower outside the lumen
constexpr double radiusStiffness = 3.0;   ///< relative to the stiffness of the curve; widths vary more slowly

VesselCurve resampleEvenly(const VesselCurve& curve, double spacingMm)
{
    const std::vector<PolylineStation> stations = evenStations<3>(curve.pointsMm, spacingMm);
    return {interpolate(curve.pointsMm, stations), interpolate(curve.radiusMm, stations)};
}

/// Returns the spline stiffness in units of the point spacing: the spline follows curvature on the scale of a radius,
/// but not irregularities of the wall.
double stiffness(const VesselCurve& curve, double stepMm)
{
    const double reach = std::max(2.0, 0.7 * medianOf(curve.radiusMm) / stepMm);
    return std::pow(reach, 4.0);
}

std::size_t nearestPoint(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& to)
{
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
        return (a - to).squaredNorm() < (b - to).squaredNorm();
    });
    return static_cast<std::size_t>(nearest - points.begin());
}

/// Counts the leading points that lie within the parent's lumen.
std::size_t countPointsInside(const VesselCurve& parent, const std::vector<Eigen::Vector3d>& points)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t at = nearestPoint(parent.pointsMm, points[i]);
        if ((parent.pointsMm[at] - points[i]).norm() > parent.radiusMm[at]) {
            return i;
        }
    }
    return points.size() - 1;
}

/// Returns the takeoff, on the parent's centerline, of a vessel that leaves the parent's wall at `exit` in `direction`:
/// halfway between the centerline point nearest to the exit and the one nearest to the backward extension.
Eigen::Vector3d takeoffOn(const VesselCurve& parent, const Eigen::Vector3d& exit, const Eigen::Vector3d& direction)
{
    const std::size_t neighbors = nearestPoint(parent.pointsMm, exit);
    const double reach = 3.0 * parent.radiusMm[neighbors];
    std::size_t best = neighbors;
    double bestDistance = 1e300;
    for (std::size_t i = 0; i < parent.pointsMm.size(); ++i) {
        const Eigen::Vector3d back = exit - parent.pointsMm[i];
        const double along = std::max(0.0, back.dot(direction));
        const double distance = (back - along * direction).norm();
        if ((parent.pointsMm[i] - parent.pointsMm[neighbors]).norm() <= reach && distance < bestDistance) {
            bestDistance = distance;
            best = i;
        }
    }
    return parent.pointsMm[(best + neighbors) / 2];
}

/// Replaces the section inside the parent by a straight line from the parent's centerline, with the radius measured
/// just outside the wall.
void straightenInsideParent(VesselCurve& curve, std::size_t inside, const VesselCurve& parent)
{
    const std::size_t ahead = std::min(curve.pointsMm.size() - 1, inside + 4);
    const Eigen::Vector3d exit = curve.pointsMm[inside];
    const Eigen::Vector3d way = curve.pointsMm[ahead] - exit;
    const Eigen::Vector3d direction = way.norm() > 1e-9 ? way.normalized().eval() : Eigen::Vector3d::Zero().eval();
    const Eigen::Vector3d takeoff = takeoffOn(parent, exit, direction);
    for (std::size_t i = 0; i < inside; ++i) {
        const double fraction = static_cast<double>(i) / static_cast<double>(inside);
        curve.pointsMm[i] = (1.0 - fraction) * takeoff + fraction * exit;
    }
    for (std::size_t i = 0; i <= std::min(inside, ahead); ++i) {
        curve.radiusMm[i] = curve.radiusMm[ahead];
    }
}

/// Points for the smoothing spline, and their weights.
struct Anchors {
    std::vector<Eigen::Vector3d> pointsMm;
    std::vector<double> weights;
};

/// Data to which a curve is fitted.
struct FitContext {
    const std::vector<Eigen::Vector3d>& way;   ///< the original path
    const PointOpacification& opacification;
    TracingProgress* progress;

    bool shouldContinue() const { return progress == nullptr || progress->advance(0.0); }
};

/// Fits the spline to the anchors. Where the spline would leave the lumen, as in very sharp bends, pulls it back to the
/// original path.
std::vector<Eigen::Vector3d> smoothInLumen(Anchors& anchors, double stiffness, std::size_t inside,
                                           const FitContext& around)
{
    const auto& [way, opacification, progress] = around;
    std::vector<Eigen::Vector3d> points = smoothSpline(anchors.pointsMm, anchors.weights, stiffness);
    for (int round = 0; round < maxPullBackRounds; ++round) {
        bool isPulledBack = false;
        for (std::size_t i = inside; i < points.size() && around.shouldContinue(); ++i) {
            const Eigen::Vector3d& onPath = way[nearestPoint(way, points[i])];
            if (opacification(points[i]) < minOpacificationOfPath * std::min(1.0, opacification(onPath))) {
                anchors.pointsMm[i] = onPath;
                anchors.weights[i] = firmWeight;
                isPulledBack = true;
            }
        }
        if (!isPulledBack) {
            break;
        }
        points = smoothSpline(anchors.pointsMm, anchors.weights, stiffness);
    }
    return points;
}

/// Performs one iteration: moves every point to the center of its cross-section, then smooths the curve, weighting each
/// section by its confidence.
void center(VesselCurve& curve, std::size_t inside, const FitContext& around, double stepMm)
{
    const std::size_t count = curve.pointsMm.size();
    const std::vector<Eigen::Vector3d> tangents = polylineTangents<3>(curve.pointsMm, 3);
    Anchors anchors{curve.pointsMm, std::vector<double>(count, 0.05)};
    std::vector<double>& weights = anchors.weights;
    std::vector<double> radii = curve.radiusMm;
    for (std::size_t i = inside; i < count && around.shouldContinue(); ++i) {
        const CrossSection section =
            measureCrossSection({curve.pointsMm[i], tangents[i], curve.radiusMm[i], stepMm}, around.opacification);
        const double farthest = 0.7 * curve.radiusMm[i] + stepMm;
        if (section.confidence > 0.0 && (section.centerMm - curve.pointsMm[i]).norm() < farthest) {
            anchors.pointsMm[i] = section.centerMm;
            radii[i] = section.radiusMm;
            weights[i] = section.confidence;
        }
    }
    if (inside > 0) {
        weights.front() = firmWeight;
    }
    curve.pointsMm = smoothInLumen(anchors, stiffness(curve, stepMm), inside, around);
    weights.front() = std::min(weights.front(), 0.05 + (inside > 0 ? 0.0 : 1.0));
    curve.radiusMm = smoothSpline(radii, weights, radiusStiffness * stiffness(curve, stepMm));
    for (double& radius : curve.radiusMm) {
        radius = std::max(radius, 0.25 * stepMm);
    }
}

bool isOutsideGrid(const Eigen::Vector3d& pointMm, const CurveSettings& settings)
{
    return ((pointMm - settings.lowMm).array() < 0.0).any() || ((pointMm - settings.highMm).array() > 0.0).any();
}

/// Extends a vessel end, shortened by thinning, along the direction of the vessel.
void extendEnd(VesselCurve& curve, const PointOpacification& opacification, const CurveSettings& settings)
{
    const std::size_t count = curve.pointsMm.size();
    const double radius = curve.radiusMm.back();
    const auto reach = static_cast<std::size_t>(std::ceil(std::max(2.0, radius / settings.voxelMm)));
    const Eigen::Vector3d tip = curve.pointsMm.back();
    const Eigen::Vector3d way = tip - curve.pointsMm[count - 1 - std::min(count - 1, reach)];
    if (way.norm() < 1e-9) {
        return;
    }
    const Eigen::Vector3d direction = way.normalized();
    double lumenMm = 0.0;   // distance from the tip to the wall ahead
    while (lumenMm < 3.0 * radius + settings.voxelMm && opacification(tip + lumenMm * direction) > 0.5) {
        lumenMm += 0.25 * settings.voxelMm;
        if (isOutsideGrid(tip + lumenMm * direction, settings)) {
            lumenMm += radius;   // the vessel continues beyond the boundary
            break;
        }
    }
    for (double away = settings.voxelMm; away < lumenMm - radius; away += settings.voxelMm) {
        curve.pointsMm.emplace_back(tip + away * direction);
        curve.radiusMm.push_back(radius);
    }
}

/// Drops points outside the grid: cross-sections truncated at the boundary can move a curve's end there.
void removePointsOutsideGrid(VesselCurve& curve, const CurveSettings& settings)
{
    const auto isFar = [&](const Eigen::Vector3d& point) {
        return ((settings.lowMm - point).array() > 0.5 * settings.voxelMm).any() ||
               ((point - settings.highMm).array() > 0.5 * settings.voxelMm).any();
    };
    while (curve.pointsMm.size() > 2 && isFar(curve.pointsMm.back())) {
        curve.pointsMm.pop_back();
        curve.radiusMm.pop_back();
    }
    const auto first = std::find_if_not(curve.pointsMm.begin(), curve.pointsMm.end() - 2, isFar);
    const std::ptrdiff_t outside = first - curve.pointsMm.begin();
    curve.pointsMm.erase(curve.pointsMm.begin(), first);
    curve.radiusMm.erase(curve.radiusMm.begin(), curve.radiusMm.begin() + outside);
}

void reverseCurve(VesselCurve& curve)
{
    std::reverse(curve.pointsMm.begin(), curve.pointsMm.end());
    std::reverse(curve.radiusMm.begin(), curve.radiusMm.end());
}

/// Extends the end to the centerline of the vessel with which it closes a loop.
void extendToAxis(VesselCurve& curve, const VesselCurve& other)
{
    reverseCurve(curve);
    straightenInsideParent(curve, countPointsInside(other, curve.pointsMm), other);
    const Eigen::Vector3d onAxis = other.pointsMm[nearestPoint(other.pointsMm, curve.pointsMm.front())];
    if ((curve.pointsMm.front() - onAxis).norm() > 1e-9) {
        curve.pointsMm.insert(curve.pointsMm.begin(), onAxis);
        curve.radiusMm.insert(curve.radiusMm.begin(), curve.radiusMm.front());
    }
    reverseCurve(curve);
}

/// Variant of `extendToAxis` for a vessel that returns to itself at `nodeMm`.
void extendToSelf(VesselCurve& curve, const Eigen::Vector3d& nodeMm)
{
    std::vector<Eigen::Vector3d> passed = curve.pointsMm;
    const double backMm = 0.25 * polylineLength<3>(passed);   // excludes the section just before the end
    while (passed.size() > 1 && polylineLength<3>(curve.pointsMm) - polylineLength<3>(passed) < backMm) {
        passed.pop_back();
    }
    curve.pointsMm.push_back(passed[nearestPoint(passed, nodeMm)]);
    curve.radiusMm.push_back(curve.radiusMm.back());
}

/// Extends free ends as far as the lumen reaches.
void extendFreeEnds(VesselCurve& curve, const BranchPath& path, const CurveNeighbors& neighbors,
                    const PointOpacification& opacification, const CurveSettings& settings)
{
    const bool isRing = neighbors.isSelfLoop && (path.pointsMm.front() - path.pointsMm.back()).norm() < 1e-9;
    if (neighbors.parent == nullptr && !isRing) {
        reverseCurve(curve);
        extendEnd(curve, opacification, settings);
        reverseCurve(curve);
    }
    if (neighbors.loopTarget == nullptr && !neighbors.isSelfLoop) {
        extendEnd(curve, opacification, settings);
    }
}

}   // namespace

VesselCurve fitVesselCurve(const BranchPath& path, const CurveNeighbors& neighbors,
                           const PointOpacification& opacification, const CurveSettings& settings)
{
    const VesselCurve* parent = neighbors.parent;
    VesselCurve curve{path.pointsMm, path.radiusMm};
    const std::vector<double> uniformWeights(curve.pointsMm.size(), 1.0);
    curve.pointsMm = smoothSpline(curve.pointsMm, uniformWeights, initialStiffness);
    extendFreeEnds(curve, path, neighbors, opacification, settings);
    curve = resampleEvenly(curve, settings.voxelMm);
    const double stepMm =
        polylineLength<3>(curve.pointsMm) / static_cast<double>(std::max<std::size_t>(1, curve.pointsMm.size() - 1));
    const std::vector<Eigen::Vector3d> way = curve.pointsMm;
    for (int round = 0; round < centeringRounds && curve.pointsMm.size() > 2; ++round) {
        const std::size_t inside = parent != nullptr ? countPointsInside(*parent, curve.pointsMm) : 0;
        if (parent != nullptr) {
            straightenInsideParent(curve, inside, *parent);
        }
        center(curve, inside, {way, opacification, settings.progress}, std::max(stepMm, 0.5 * settings.voxelMm));
        removePointsOutsideGrid(curve, settings);
    }
    if (neighbors.loopTarget != nullptr) {
        extendToAxis(curve, *neighbors.loopTarget);
    } else if (neighbors.isSelfLoop) {
        extendToSelf(curve, path.pointsMm.back());
    }
    return resampleEvenly(curve, settings.pointSpacingMm);
}

}   // namespace angiopose::core
