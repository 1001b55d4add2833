#include "core/registration/wire/wire_curve.h"

#include "core/vessel/polyline.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace angiopose::core {
namespace {

constexpr std::size_t tangentReach = 2;   // number of points on either side used for a tangent
using Line = Polyline<2>;

std::vector<Line> linesOf(const TargetSamples& target)
{
    std::vector<Line> lines;
    for (std::size_t i = 0; i < target.size(); ++i) {
        if (i == 0 || target.curveIndex[i] != target.curveIndex[i - 1]) {
            lines.emplace_back();
        }
        lines.back().push_back(target.points[i]);
    }
    return lines;
}

/// Possible connection between an end of the chain and another line.
struct Joint {
    std::size_t line = 0;
    bool atFront = false;   ///< whether the line attaches to the front of the chain
    bool isReversed = false;   ///< whether the line must be reversed
    double gapPx = std::numeric_limits<double>::infinity();
};

Joint nearestJoint(const Line& chain, const std::vector<Line>& lines)
{
    Joint best;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const bool atFront : {false, true}) {
            for (const bool isReversed : {false, true}) {
                const Eigen::Vector2d& end = atFront ? chain.front() : chain.back();
                const Eigen::Vector2d& other = atFront != isReversed ? lines[i].back() : lines[i].front();
                const double gapPx = (end - other).norm();
                if (gapPx < best.gapPx) {
                    best = {i, atFront, isReversed, gapPx};
                }
            }
        }
    }
    return best;
}

void join(Line& chain, Line line, const Joint& joint)
{
    if (joint.isReversed) {
        std::ranges::reverse(line);
    }
    chain.insert(joint.atFront ? chain.begin() : chain.end(), line.begin(), line.end());
}

void measure(WireCurve& curve)
{
    curve.tangents = polylineTangents<2>(curve.pointsPx, tangentReach);
    curve.alongPx.assign(1, 0.0);
    for (std::size_t k = 1; k < curve.size(); ++k) {
        curve.alongPx.push_back(curve.alongPx.back() + (curve.pointsPx[k] - curve.pointsPx[k - 1]).norm());
    }
}

}   // namespace

WireCurve wireCurve(const TargetSamples& target, double spacingPx, std::size_t maxPoints)
{
    std::vector<Line> lines = linesOf(target);
    std::ranges::stable_sort(lines, std::ranges::greater(), [](const Line& line) { return polylineLength<2>(line); });
    Line chain = lines.front();
    lines.erase(lines.begin());
    double gapsPx = 0.0;
    while (!lines.empty()) {
        const Joint joint = nearestJoint(chain, lines);
        gapsPx += joint.gapPx;
        const auto line = std::next(lines.begin(), static_cast<std::ptrdiff_t>(joint.line));
        join(chain, std::move(*line), joint);
        lines.erase(line);
    }
    const double lengthPx = polylineLength<2>(chain);
    WireCurve curve;
    curve.pointsPx =
        interpolate(chain, evenStations<2>(chain, std::max(spacingPx, lengthPx / static_cast<double>(maxPoints))));
    curve.gapFraction = lengthPx > 0.0 ? gapsPx / lengthPx : 0.0;
    measure(curve);
    return curve;
}

WireCurve reversed(const WireCurve& curve)
{
    WireCurve turned = curve;
    std::ranges::reverse(turned.pointsPx);
    measure(turned);
    return turned;
}

}   // namespace angiopose::core
