#include "core/tracing/angiogram/curves/vessel_branches.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"
#include "core/tracing/angiogram/curves/misregistered_edge.h"
#include "core/tracing/angiogram/curves/prune_graph.h"
#include "core/tracing/angiogram/curves/thin_mask.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

// A side branch must be long or strong: its score is √length × (20th percentile of its evidence − 0.5).
constexpr double minBranchEvidence = 0.5;
constexpr double minBranchScore = 4.5;
constexpr double weakQuantile = 0.2;
constexpr double minComponentScore = 11.0;   // isolated components need more evidence
// Near the edge of the field, the filters see only half of their neighborhood: a curve that stays mostly within this
// distance of the edge is an artifact.
constexpr int edgeMarginPx = 6;
constexpr double maxFractionAtEdge = 0.6;

double lengthOf(const SkeletonEdge& edge)
{
    return polylineLength(edge.pointsPx);
}

std::vector<float> evidenceAlong(const SkeletonEdge& edge, const ImageF& evidence)
{
    std::vector<float> along;
    for (const Eigen::Vector2d& point : edge.pointsPx) {
        along.push_back(sampleBilinear(evidence, point.x(), point.y()));
    }
    return along;
}

/// Returns the field eroded by `edgeMarginPx`; pixels beyond the image count as outside.
Mask2d erodeField(const Mask2d& field)
{
    Mask2d inside = erode(field, edgeMarginPx);
    for (int y = 0; y < inside.height; ++y) {
        for (int x = 0; x < inside.width; ++x) {
            const int toEdge = std::min(std::min(x, inside.width - 1 - x), std::min(y, inside.height - 1 - y));
            inside.at(x, y) = toEdge < edgeMarginPx ? 0 : inside.at(x, y);
        }
    }
    return inside;
}

bool runsAlongFieldEdge(const SkeletonEdge& edge, const Mask2d& inside)
{
    const auto outside = std::count_if(edge.pointsPx.begin(), edge.pointsPx.end(), [&](const Eigen::Vector2d& point) {
        return inside.at(static_cast<int>(std::lround(point.x())), static_cast<int>(std::lround(point.y()))) == 0;
    });
    return static_cast<double>(outside) > maxFractionAtEdge * static_cast<double>(edge.pointsPx.size());
}

}   // namespace

SkeletonGraph extractVesselBranches(const Mask2d& vessels, const ImageF& evidence, const ImageF& opacity,
                                    const Mask2d& field, const TraceOptions& options)
{
    const auto score = [&](const SkeletonEdge& edge) {
        const double length = lengthOf(edge);
        const double weak = grayQuantile(evidenceAlong(edge, evidence), weakQuantile);
        return length < options.minBranchLengthPx ? 0.0 : std::sqrt(length) * (weak - minBranchEvidence);
    };
    const Mask2d inside = erodeField(field);
    SkeletonGraph graph = buildSkeletonGraph(skeletonize(vessels));
    std::erase_if(graph.edges, [&](const SkeletonEdge& edge) {
        return runsAlongFieldEdge(edge, inside) || isMisregisteredEdge(edge.pointsPx, opacity);
    });
    graph = removeSpurs(std::move(graph), lengthOf, options.minBranchLengthPx);
    graph = removeSpurs(std::move(graph), score, minBranchScore);
    graph = removeSmallComponents(std::move(graph), lengthOf, options.minComponentLengthPx);
    return removeSmallComponents(std::move(graph), score, minComponentScore);
}

SkeletonGraph extractDrawnBranches(const Mask2d& vessels, const TraceOptions& options)
{
    SkeletonGraph graph = buildSkeletonGraph(skeletonize(vessels));
    graph = removeSpurs(std::move(graph), lengthOf, options.minBranchLengthPx);
    return removeSmallComponents(std::move(graph), lengthOf, options.minComponentLengthPx);
}

}   // namespace angiopose::core
