#include "core/tracing/angiogram/curves/earlier_structures.h"

#include "core/imaging/image_filters.h"

#include <algorithm>
#include <array>

namespace angiopose::core {
namespace {

constexpr int maxLateralShiftPx = 4;   // maximum lateral shift; catheters move with the heart
constexpr int shiftCount = 2 * maxLateralShiftPx + 1;
constexpr int reachPoints = 7;   // points averaged on either side to suppress noise
constexpr double backgroundDistancePx = 2.5;   // distance from the wall to the background samples
constexpr double minRelativeDepth = 0.5;
constexpr double minCurveFraction = 0.6;
constexpr std::size_t minFrames = 5;
constexpr std::size_t maxFrames = 9;   // more frames add no information
constexpr double minFrameFraction = 0.85;
constexpr double minTraceFraction = 0.8;
constexpr double maxDeviceFraction = 0.35;   // fraction of the traced length; above, vessels were already opacified

using Depths = std::array<double, shiftCount>;   ///< depth of the dark line at each lateral shift

/// Returns how much darker (in gray values) the frame is on the line than on either side of it.
double depthAt(const ImageF& frame, double sign, const Eigen::Vector2d& point, const Eigen::Vector2d& aside)
{
    const auto valueAt = [&](const Eigen::Vector2d& at) { return sign * sampleBilinear(frame, at.x(), at.y()); };
    return std::min(valueAt(point + aside), valueAt(point - aside)) - valueAt(point);
}

std::vector<Depths> depthsAlong(const Curve2d& curve, const ImageF& frame, double sign)
{
    const std::vector<Eigen::Vector2d> tangents = tangentsOf(curve.pointsPx, 4);
    std::vector<Depths> depths(curve.pointsPx.size());
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const Eigen::Vector2d normal(-tangents[i].y(), tangents[i].x());
        for (int k = 0; k < shiftCount; ++k) {
            depths[i][static_cast<std::size_t>(k)] =
                depthAt(frame, sign, curve.pointsPx[i] + (k - maxLateralShiftPx) * normal,
                        (curve.radiusPx[i] + backgroundDistancePx) * normal);
        }
    }
    return depths;
}

/// Averages the depths over the points around the i-th point, separately for each shift.
Depths meanAround(const std::vector<Depths>& depths, std::size_t i)
{
    const std::size_t first = i >= reachPoints ? i - reachPoints : 0;
    const std::size_t last = std::min(depths.size() - 1, i + reachPoints);
    Depths mean{};
    for (std::size_t j = first; j <= last; ++j) {
        for (std::size_t k = 0; k < mean.size(); ++k) {
            mean[k] += depths[j][k] / static_cast<double>(last - first + 1);
        }
    }
    return mean;
}

/// Returns the fraction of curve points at which nearly all other frames show a line within 1 px, at least half as
/// deep.
double stationaryFraction(const Curve2d& curve, const ImageF& frame, const std::vector<const ImageF*>& others,
                          double sign)
{
    const std::vector<Depths> current = depthsAlong(curve, frame, sign);
    std::vector<std::size_t> seen(current.size(), 0);
    for (const ImageF* other : others) {
        const std::vector<Depths> there = depthsAlong(curve, *other, sign);
        for (std::size_t i = 0; i < current.size(); ++i) {
            const double depth = meanAround(current, i)[maxLateralShiftPx];
            const Depths mean = meanAround(there, i);
            const double near =
                std::max({mean[maxLateralShiftPx - 1], mean[maxLateralShiftPx], mean[maxLateralShiftPx + 1]});
            seen[i] += depth > 0.0 && near >= minRelativeDepth * depth ? 1 : 0;
        }
    }
    const auto isStationary = [&](std::size_t count) {
        return static_cast<double>(count) >= minFrameFraction * static_cast<double>(others.size());
    };
    return static_cast<double>(std::ranges::count_if(seen, isStationary)) / static_cast<double>(current.size());
}

double visibleFraction(const Curve2d& curve, const ImageF& frame, const ImageF& earlierFrame, double sign)
{
    if (curve.pointsPx.empty() || curve.radiusPx.size() != curve.pointsPx.size()) {
        return 0.0;
    }
    const std::vector<Depths> current = depthsAlong(curve, frame, sign);
    const std::vector<Depths> earlier = depthsAlong(curve, earlierFrame, sign);
    int seen = 0;
    for (std::size_t i = 0; i < current.size(); ++i) {
        const double depth = meanAround(current, i)[maxLateralShiftPx];
        seen += depth > 0.0 && std::ranges::max(meanAround(earlier, i)) >= minRelativeDepth * depth ? 1 : 0;
    }
    return static_cast<double>(seen) / static_cast<double>(current.size());
}

}   // namespace

std::vector<double> fractionsVisibleBefore(const Centerline2d& centerline, const ImageF& frame,
                                           const ImageF& earlierFrame, Polarity polarity)
{
    const double sign = polarity == Polarity::VesselsDark ? 1.0 : -1.0;
    std::vector<double> shares;
    for (const Curve2d& curve : centerline.curves) {
        shares.push_back(visibleFraction(curve, frame, earlierFrame, sign));
    }
    return shares;
}

EarlierStructures findEarlierStructures(const Centerline2d& centerline, const ImageF& frame, const ImageF& earlierFrame,
                                        Polarity polarity)
{
    if (earlierFrame.width != frame.width || earlierFrame.height != frame.height) {
        return {};
    }
    const std::vector<double> shares = fractionsVisibleBefore(centerline, frame, earlierFrame, polarity);
    double length = 0.0;
    double visibleLength = 0.0;
    EarlierStructures result;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const Curve2d& curve = centerline.curves[k];
        length += curve.lengthPx();
        visibleLength += shares[k] * curve.lengthPx();
        if (shares[k] >= minCurveFraction) {
            result.curveIds.push_back(curve.id);
        }
    }
    result.isNearlyAll = length > 0.0 && visibleLength >= minTraceFraction * length;
    if (visibleLength > maxDeviceFraction * length) {
        result.curveIds.clear();
    }
    return result;
}

std::vector<int> findStationaryCurves(const Centerline2d& centerline, const std::vector<ImageF>& frames, int frame,
                                      Polarity polarity)
{
    if (frames.size() < minFrames) {
        return {};
    }
    const ImageF& shown = frames[static_cast<std::size_t>(frame)];
    std::vector<const ImageF*> others;
    const std::size_t count = std::min(maxFrames, frames.size());
    for (std::size_t k = 0; k < count; ++k) {
        const ImageF& other = frames[k * (frames.size() - 1) / (count - 1)];
        if (&other != &shown && other.width == shown.width && other.height == shown.height) {
            others.push_back(&other);
        }
    }
    const double sign = polarity == Polarity::VesselsDark ? 1.0 : -1.0;
    std::vector<int> stationary;
    for (const Curve2d& curve : centerline.curves) {
        const bool isMeasured = !curve.pointsPx.empty() && curve.radiusPx.size() == curve.pointsPx.size();
        if (isMeasured && stationaryFraction(curve, shown, others, sign) >= minCurveFraction) {
            stationary.push_back(curve.id);
        }
    }
    return stationary;
}

}   // namespace angiopose::core
