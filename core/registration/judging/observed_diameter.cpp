#include "core/registration/judging/observed_diameter.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace angiopose::core {
namespace {

constexpr std::size_t minPairs = 20;
constexpr double minRatio = 0.67;   // minimum width ratio of a lumen; a guidewire is narrower relative to its vessel
constexpr double maxRatio = 1.5;
constexpr double likeTheTree = 0.7;
constexpr double minChange = 0.1;   // minimum σ of the log widths; catheters and other devices have a constant width

struct WidthPair {
    double seenMm;
    double expectedMm;
};

std::vector<WidthPair> widthPairs(const RegistrationProblem& problem, const TargetLines& target,
                                  const RigidTransform& pose, const ProjectedTree& projected)
{
    std::vector<WidthPair> pairs;
    for (std::size_t i = 0; i < problem.tree.size(); ++i) {
        const double expectedMm = 2.0 * problem.tree.radiusMm[i];
        const Eigen::Vector3d inCamera = pose * problem.tree.points[i];
        const auto pixel = project(problem.camera, inCamera);
        if (!(expectedMm > 0.0) || !pixel || !(projected.distancePx[i] <= matchTolerancePx)) {
            continue;
        }
        const auto line = &target.nearest(pixel->x(), pixel->y()) - target.lines().data();
        const double seenPx = 2.0 * problem.target.radiusPx[static_cast<std::size_t>(line)];
        if (seenPx > 0.0) {
            pairs.push_back({seenPx * millimetersPerPixel(problem.camera, inCamera.z()), expectedMm});
        }
    }
    return pairs;
}

double middle(const std::vector<WidthPair>& pairs, double (*value)(const WidthPair&))
{
    std::vector<double> values;
    std::ranges::transform(pairs, std::back_inserter(values), value);
    return medianOf(std::move(values));
}

/// Returns the Pearson correlation of the log widths.
double correlationOf(const std::vector<WidthPair>& pairs)
{
    const double count = static_cast<double>(pairs.size());
    double seen = 0.0, expected = 0.0;
    for (const WidthPair& pair : pairs) {
        seen += std::log(pair.seenMm) / count;
        expected += std::log(pair.expectedMm) / count;
    }
    double both = 0.0, ofSeen = 0.0, ofExpected = 0.0;
    for (const WidthPair& pair : pairs) {
        const double s = std::log(pair.seenMm) - seen;
        const double e = std::log(pair.expectedMm) - expected;
        both += s * e / count;
        ofSeen += s * s / count;
        ofExpected += e * e / count;
    }
    const bool changes = std::min(ofSeen, ofExpected) > minChange * minChange;
    return changes ? both / std::sqrt(ofSeen * ofExpected) : 0.0;
}

}   // namespace

ObservedDiameter observedDiameter(const RegistrationProblem& problem, const TargetLines& target,
                                  const RigidTransform& cameraFromPatient, const ProjectedTree& projected)
{
    const std::vector<WidthPair> pairs = widthPairs(problem, target, cameraFromPatient, projected);
    if (pairs.empty()) {
        return {};
    }
    return {pairs.size(), middle(pairs, [](const WidthPair& pair) { return pair.seenMm / pair.expectedMm; }),
            correlationOf(pairs)};
}

bool isLumen(const ObservedDiameter& diameter)
{
    return diameter.pairs >= minPairs && diameter.ratio >= minRatio && diameter.ratio <= maxRatio &&
           diameter.correlation >= likeTheTree;
}

}   // namespace angiopose::core
