#include "tests/support/tracing_score.h"

#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"
#include "core/imaging/wide_gaussian_blur.h"
#include "core/support/quantile.h"
#include "tests/support/for_each.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::test {
namespace {

using core::Centerline2d;
using core::Curve2d;
using core::ImageF;
using core::Mask2d;

constexpr double minCountedRadiusPx = 1.0;
constexpr double minContrastToNoise = 2.0;
constexpr double tolerancePx = 2.0;
constexpr double besideWallsPx = 2.0;
constexpr double surroundingsPx = 8.0;
constexpr int rimPx = 5;
constexpr double shortestForBiasPx = 20.0;

Mask2d exposedInside(const ImageF& frame)
{
    Mask2d exposed(frame.width + 2, frame.height + 2);   // with the image edge as a border
    test::forEachPixel(frame.width, frame.height,
                       [&](int x, int y) { exposed.at(x + 1, y + 1) = frame.at(x, y) > 0.0F ? 255 : 0; });
    exposed = core::erode(exposed, rimPx);
    Mask2d inside(frame.width, frame.height);
    test::forEachPixel(frame.width, frame.height, [&](int x, int y) { inside.at(x, y) = exposed.at(x + 1, y + 1); });
    return inside;
}

/// Local standard deviation of the frame without its contrast agent, after removing slow variations.
ImageF noiseAround(const ImageF& frame, const ImageF& contrast)
{
    ImageF weight(frame.width, frame.height);
    ImageF rest(frame.width, frame.height);
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        weight.pixels[i] = frame.pixels[i] > 0.0F ? 1.0F : 0.0F;
        rest.pixels[i] = weight.pixels[i] * (frame.pixels[i] + contrast.pixels[i]);
    }
    const ImageF mass = core::wideGaussianBlur(weight, surroundingsPx);
    const ImageF slow = core::wideGaussianBlur(rest, surroundingsPx);
    for (std::size_t i = 0; i < rest.pixels.size(); ++i) {
        const float difference = rest.pixels[i] - weight.pixels[i] * slow.pixels[i] / std::max(1e-3F, mass.pixels[i]);
        rest.pixels[i] = difference * difference;
    }
    ImageF deviation = core::wideGaussianBlur(rest, surroundingsPx);
    for (std::size_t i = 0; i < deviation.pixels.size(); ++i) {
        deviation.pixels[i] = std::sqrt(deviation.pixels[i] / std::max(1e-3F, mass.pixels[i]));
    }
    return deviation;
}

double ownContrast(const ImageF& contrast, const Eigen::Vector2d& point, const Eigen::Vector2d& tangent, double radius)
{
    const Eigen::Vector2d side = (radius + besideWallsPx) * Eigen::Vector2d(-tangent.y(), tangent.x());
    const auto at = [&](const Eigen::Vector2d& p) { return core::sampleBilinear(contrast, p.x(), p.y()); };
    return at(point) - std::max(at(point + side), at(point - side));
}

struct Near {
    double distancePx = std::numeric_limits<double>::max();
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();
    double radiusPx = 0.0;
};

Near nearestOnCurves(const Centerline2d& centerline, const Eigen::Vector2d& point)
{
    Near near;
    for (const Curve2d& curve : centerline.curves) {
        for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
            const Eigen::Vector2d offset = curve.pointsPx[i] - point;
            if (offset.squaredNorm() < near.distancePx * near.distancePx) {
                near = {offset.norm(), offset, curve.radiusPx[i]};
            }
        }
    }
    return near;
}

bool insideLumenOf(const Centerline2d& vessels, const Curve2d* except, const Eigen::Vector2d& point)
{
    for (const Curve2d& curve : vessels.curves) {
        for (std::size_t i = 0; i < curve.pointsPx.size() && &curve != except; ++i) {
            if ((curve.pointsPx[i] - point).squaredNorm() < curve.radiusPx[i] * curve.radiusPx[i]) {
                return true;
            }
        }
    }
    return false;
}

void scoreVessels(const core::SimulatedCase& simulated, const Centerline2d& traced, TracingScore& score)
{
    const ImageF& frame = simulated.angiogram.frames[static_cast<std::size_t>(simulated.angiogram.suggestedFrame)];
    const ImageF noise = noiseAround(frame, simulated.trueContrast);
    const Mask2d inside = exposedInside(frame);
    const Centerline2d truth = core::resampled(simulated.trueTarget, 1.0);
    Eigen::Vector2d offsets = Eigen::Vector2d::Zero();
    std::vector<double> radiusRatios;
    double sidewaysSum = 0.0;
    int curveCount = 0;
    for (const Curve2d& curve : truth.curves) {
        const auto tangents = core::tangentsOf(curve.pointsPx, 3);
        double sideways = 0.0;
        double found = 0.0;
        for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
            const Eigen::Vector2d& point = curve.pointsPx[i];
            const int x = static_cast<int>(std::lround(point.x()));
            const int y = static_cast<int>(std::lround(point.y()));
            if (!inside.contains(x, y) || inside.at(x, y) == 0 || curve.radiusPx[i] <= minCountedRadiusPx ||
                ownContrast(simulated.trueContrast, point, tangents[i], curve.radiusPx[i]) <
                    minContrastToNoise * noise.at(x, y) ||
                insideLumenOf(truth, &curve, point)) {
                continue;
            }
            score.visiblePx += 1.0;
            const Near near = nearestOnCurves(traced, point);
            if (near.distancePx <= tolerancePx) {
                found += 1.0;
                offsets += near.offset;
                radiusRatios.push_back(near.radiusPx / curve.radiusPx[i]);
                sideways += near.offset.dot(Eigen::Vector2d(-tangents[i].y(), tangents[i].x()));
            }
        }
        score.foundPx += found;
        if (found >= shortestForBiasPx) {
            sidewaysSum += std::abs(sideways / found);
            ++curveCount;
        }
    }
    score.radiusRatio = radiusRatios.empty() ? 0.0 : core::quantile(radiusRatios, 0.5);
    score.biasPx = score.foundPx > 0.0 ? (offsets / score.foundPx).norm() : 0.0;
    score.curveBiasPx = curveCount > 0 ? sidewaysSum / curveCount : 0.0;
}

}   // namespace

TracingScore scoreTracing(const core::SimulatedCase& simulated, const core::AngiogramTrace& trace)
{
    TracingScore score;
    const Centerline2d traced = core::resampled(trace.centerline, 0.5);
    scoreVessels(simulated, traced, score);
    const Centerline2d vessels = core::resampled(simulated.trueTarget, 0.5);
    const Centerline2d catheter = core::resampled(simulated.trueCatheter, 0.5);
    for (const Curve2d& curve : core::resampled(trace.centerline, 1.0).curves) {
        const bool isSuspect =
            std::find(trace.suspectCurves.begin(), trace.suspectCurves.end(), curve.id) != trace.suspectCurves.end();
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            const Near near = nearestOnCurves(vessels, point);
            const bool isVessel = near.distancePx <= tolerancePx || insideLumenOf(vessels, nullptr, point);
            const bool isCatheter = !isVessel && nearestOnCurves(catheter, point).distancePx <= tolerancePx;
            const bool isFalse = !isVessel && !isCatheter;
            score.catheterPx += isCatheter ? 1.0 : 0.0;
            score.flaggedCatheterPx += isCatheter && isSuspect ? 1.0 : 0.0;
            score.tracedPx += 1.0;
            score.falsePx += isFalse ? 1.0 : 0.0;
            score.falseUnsuspectedPx += isFalse && !isSuspect ? 1.0 : 0.0;
            score.suspectVesselPx += isVessel && isSuspect ? 1.0 : 0.0;
        }
    }
    return score;
}

}   // namespace angiopose::test
