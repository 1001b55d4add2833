#include "core/tracing/angiogram/curves/skeleton_graph.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

// Two arms continue each other if the angle between them is below about 45°, or below 35° at a crossing.
constexpr double straightCosine = -0.7;
constexpr double crossingCosine = -0.82;
// The direction of an arm is measured past the junction, where thinning distorts the skeleton.
constexpr std::size_t armStart = 3;
constexpr std::size_t armEnd = 12;

/// One end of an edge: arm 2i is the start of edge i, arm 2i + 1 is its end.
using Arm = std::size_t;
constexpr Arm noArm = static_cast<Arm>(-1);

const SkeletonEdge& edgeOf(const SkeletonGraph& graph, Arm arm)
{
    return graph.edges[arm / 2];
}

int nodeOf(const SkeletonGraph& graph, Arm arm)
{
    return arm % 2 == 0 ? edgeOf(graph, arm).startNode : edgeOf(graph, arm).endNode;
}

Arm otherEnd(Arm arm)
{
    return arm ^ 1U;
}

/// Returns the unit direction in which the arm leaves its node.
Eigen::Vector2d directionOf(const SkeletonGraph& graph, Arm arm)
{
    const auto& points = edgeOf(graph, arm).pointsPx;
    const std::size_t last = points.size() - 1;
    const std::size_t far = std::min(armEnd, last);
    const std::size_t near = std::min(armStart, far / 2);
    const auto at = [&](std::size_t i) { return arm % 2 == 0 ? points[i] : points[last - i]; };
    return (at(far) - at(near)).normalized();
}

std::vector<std::vector<Arm>> armsByNode(const SkeletonGraph& graph)
{
    std::vector<std::vector<Arm>> arms(graph.nodesPx.size());
    for (Arm arm = 0; arm < 2 * graph.edges.size(); ++arm) {
        arms[static_cast<std::size_t>(nodeOf(graph, arm))].push_back(arm);
    }
    return arms;
}

/// Returns whether the arms at both ends of a short edge form two straight lines through the edge.
bool isCrossing(const SkeletonGraph& graph, std::vector<Arm> armsAtStart, std::vector<Arm> armsAtEnd, std::size_t edge)
{
    const auto isOnEdge = [edge](Arm arm) { return arm / 2 == edge; };
    std::erase_if(armsAtStart, isOnEdge);
    std::erase_if(armsAtEnd, isOnEdge);
    if (armsAtStart.size() != 2 || armsAtEnd.size() != 2) {
        return false;
    }
    const auto straight = [&](Arm a, Arm b) {
        return directionOf(graph, a).dot(directionOf(graph, b)) < crossingCosine;
    };
    return (straight(armsAtStart[0], armsAtEnd[0]) && straight(armsAtStart[1], armsAtEnd[1])) ||
           (straight(armsAtStart[0], armsAtEnd[1]) && straight(armsAtStart[1], armsAtEnd[0]));
}

/// Attaches the end of the arm to a new node and removes the distorted points within `gapPx` of that node.
void reattach(SkeletonGraph& graph, Arm arm, int node, double gapPx)
{
    SkeletonEdge& edge = graph.edges[arm / 2];
    const Eigen::Vector2d target = graph.nodesPx[static_cast<std::size_t>(node)];
    if (arm % 2 == 1) {
        std::reverse(edge.pointsPx.begin(), edge.pointsPx.end());
    }
    auto first = edge.pointsPx.begin();
    while (edge.pointsPx.end() - first > 2 && (*first - target).norm() < gapPx) {
        ++first;
    }
    edge.pointsPx.erase(edge.pointsPx.begin(), first);
    edge.pointsPx.insert(edge.pointsPx.begin(), target);
    if (arm % 2 == 1) {
        std::reverse(edge.pointsPx.begin(), edge.pointsPx.end());
    }
    (arm % 2 == 0 ? edge.startNode : edge.endNode) = node;
}

/// Merges pairs of junctions that thinning creates at a crossing into one node.
SkeletonGraph withCrossingsMerged(SkeletonGraph graph, double crossingPx)
{
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const SkeletonEdge edge = graph.edges[i];
        const double length = polylineLength(edge.pointsPx);
        if (edge.startNode == edge.endNode || length > crossingPx) {
            continue;
        }
        const auto arms = armsByNode(graph);
        const auto& armsAtStart = arms[static_cast<std::size_t>(edge.startNode)];
        const auto& armsAtEnd = arms[static_cast<std::size_t>(edge.endNode)];
        if (!isCrossing(graph, armsAtStart, armsAtEnd, i)) {
            continue;
        }
        const int center = static_cast<int>(graph.nodesPx.size());
        graph.nodesPx.emplace_back(0.5 * (edge.pointsPx.front() + edge.pointsPx.back()));
        for (const auto* group : {&armsAtStart, &armsAtEnd}) {
            for (const Arm arm : *group) {
                if (arm / 2 != i) {
                    reattach(graph, arm, center, length);
                }
            }
        }
        graph.edges.erase(graph.edges.begin() + static_cast<std::ptrdiff_t>(i));
        --i;
    }
    return graph;
}

/// Returns, for each arm, the arm that continues it straight through the shared node, or noArm.
std::vector<Arm> continuations(const SkeletonGraph& graph)
{
    struct Pair {
        double cosine;
        Arm first;
        Arm second;
    };
    std::vector<Arm> partner(2 * graph.edges.size(), noArm);
    for (const std::vector<Arm>& arms : armsByNode(graph)) {
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < arms.size(); ++i) {
            for (std::size_t j = i + 1; j < arms.size(); ++j) {
                const double cosine = directionOf(graph, arms[i]).dot(directionOf(graph, arms[j]));
                if (cosine < straightCosine || arms.size() == 2) {
                    pairs.push_back({cosine, arms[i], arms[j]});
                }
            }
        }
        std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.cosine < b.cosine; });
        for (const Pair& pair : pairs) {
            if (partner[pair.first] == noArm && partner[pair.second] == noArm) {
                partner[pair.first] = pair.second;
                partner[pair.second] = pair.first;
            }
        }
    }
    return partner;
}

/// Concatenates the points of all edges from `arm` onward, each traversed from one end to the other.
std::vector<Eigen::Vector2d> chainFrom(const SkeletonGraph& graph, Arm arm, const std::vector<Arm>& partner,
                                       std::vector<bool>& used)
{
    std::vector<Eigen::Vector2d> chain;
    while (arm != noArm && !used[arm / 2]) {
        used[arm / 2] = true;
        std::vector<Eigen::Vector2d> points = edgeOf(graph, arm).pointsPx;
        if (arm % 2 == 1) {
            std::reverse(points.begin(), points.end());
        }
        chain.insert(chain.end(), points.begin() + (chain.empty() ? 0 : 1), points.end());
        arm = partner[otherEnd(arm)];
    }
    return chain;
}

}   // namespace

std::vector<std::vector<Eigen::Vector2d>> orderCurves(const SkeletonGraph& graph, double crossingPx)
{
    const SkeletonGraph merged = withCrossingsMerged(graph, crossingPx);
    const std::vector<Arm> partner = continuations(merged);
    std::vector<bool> used(merged.edges.size(), false);
    std::vector<std::vector<Eigen::Vector2d>> curves;
    for (Arm arm = 0; arm < partner.size(); ++arm) {
        if (partner[arm] == noArm && !used[arm / 2]) {
            curves.push_back(chainFrom(merged, arm, partner, used));
        }
    }
    for (Arm arm = 0; arm < partner.size(); ++arm) {   // only closed rings remain
        if (!used[arm / 2]) {
            curves.push_back(chainFrom(merged, arm, partner, used));
        }
    }
    return curves;
}

}   // namespace angiopose::core
