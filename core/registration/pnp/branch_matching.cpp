#include "core/registration/pnp/branch_matching.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t samplesPerEdge = 24;
constexpr double visitedReaches = 2.5;
constexpr double minCloseness = 0.05;   // minimum closeness of a candidate, 0…1
constexpr std::size_t maxCurvesPerEdge = 6;
constexpr double closenessOfNone = 0.1;   // closeness assigned to the alternative that no curve matches
constexpr int relaxations = 8;
constexpr double ownWeight = 0.25;   // weight of an edge's own probability relative to the support of its neighbors
constexpr double supportOfNone = 0.25;
constexpr double pairedReaches = 3.0;
constexpr double minPairCosine = 0.5;
constexpr double minProjectedShare =
    1e-3;   // minimum projected fraction of the length; below it, the vessel is seen end-on

std::vector<std::vector<int>> neighborsIn(const BranchGraph& graph)
{
    std::vector<std::vector<int>> neighbors(graph.edges.size());
    for (const std::vector<EdgeEnd>& ends : graph.nodes) {
        for (const EdgeEnd& a : ends) {
            for (const EdgeEnd& b : ends) {
                if (a.edge != b.edge) {
                    neighbors[static_cast<std::size_t>(a.edge)].push_back(b.edge);
                }
            }
        }
    }
    return neighbors;
}

std::set<std::pair<int, int>> connectionsIn(const BranchGraph& graph)
{
    std::set<std::pair<int, int>> connections;
    for (const std::vector<EdgeEnd>& ends : graph.nodes) {
        for (const EdgeEnd& a : ends) {
            for (const EdgeEnd& b : ends) {
                connections.emplace(graph.edges[static_cast<std::size_t>(a.edge)].curve,
                                    graph.edges[static_cast<std::size_t>(b.edge)].curve);
            }
        }
    }
    return connections;
}

}   // namespace

BranchMatcher::BranchMatcher(const RegistrationProblem& problem)
    : problem_(problem),
      tree_(graphOf(problem.tree)),
      neighbors_(neighborsIn(tree_)),
      connectedCurves_(connectionsIn(graphOf(problem.target)))
{
    const std::vector<int>& index = problem.target.curveIndex;
    for (std::size_t j = 0; j < index.size(); ++j) {
        curves_.try_emplace(index[j], CurveRange{j, j}).first->second.to = j + 1;
    }
}

std::optional<BranchMatcher::ProjectedSample> BranchMatcher::projectSample(std::size_t point,
                                                                           const CentroidPose& pose) const
{
    const TreeSamples& tree = problem_.tree;
    const Eigen::Vector3d place = pose.rotation * (tree.points[point] - tree.centroid) + pose.centroidInCamera;
    const auto pixel = project(problem_.camera, place);
    if (!pixel) {
        return {};
    }
    const Eigen::Vector2d along = projectionJacobian(problem_.camera, place) * (pose.rotation * tree.tangents[point]);
    if (along.norm() < minProjectedShare * std::abs(problem_.camera.fx) / place.z()) {
        return {};
    }
    return ProjectedSample{*pixel, along.normalized()};
}

/// Returns, for each curve, the closeness to the edge, averaged over the points of the edge.
BranchMatcher::Candidates BranchMatcher::closenessOf(const BranchEdge& edge, const CentroidPose& pose, double reachPx,
                                                     const BinGrid& grid) const
{
    const TargetSamples& target = problem_.target;
    const std::size_t stride = std::max<std::size_t>(1, edge.size() / samplesPerEdge);
    Candidates means;
    const auto count = static_cast<double>((edge.size() + stride - 1) / stride);
    for (std::size_t i = edge.from; i < edge.to; i += stride) {
        const auto sample = projectSample(i, pose);
        if (!sample) {
            continue;
        }
        Candidates best;
        grid.visitNear(sample->pixel, [&](std::size_t j) {
            const double squared = (target.points[j] - sample->pixel).squaredNorm();
            const double cosine = target.tangents[j].dot(sample->direction);
            const double closeness = std::exp(-0.5 * squared / (reachPx * reachPx)) * cosine * cosine;
            double& known = best[target.curveIndex[j]];
            known = std::max(known, closeness);
        });
        for (const auto& [curve, closeness] : best) {
            means[curve] += closeness / count;
        }
    }
    return means;
}

BranchMatcher::Candidates BranchMatcher::candidatesOf(const Candidates& closeness)
{
    std::vector<std::pair<double, int>> ranked;   // in descending order of closeness
    for (const auto& [curve, mean] : closeness) {
        if (mean >= minCloseness) {
            ranked.emplace_back(-mean, curve);
        }
    }
    std::ranges::sort(ranked);
    ranked.resize(std::min(ranked.size(), maxCurvesPerEdge));
    double whole = closenessOfNone;
    for (const auto& [negative, curve] : ranked) {
        whole -= negative;
    }
    Candidates candidates;
    for (const auto& [negative, curve] : ranked) {
        candidates[curve] = -negative / whole;
    }
    return candidates;
}

/// Returns the mean probability, over the neighboring edges, that the neighbor is matched to a curve that meets this
/// one; the probability that a neighbor is unmatched contributes supportOfNone.
double BranchMatcher::supportOf(int curve, const std::vector<int>& neighbors,
                                const std::vector<Candidates>& candidates) const
{
    if (neighbors.empty()) {
        return supportOfNone;
    }
    double support = 0.0;
    for (const int neighbor : neighbors) {
        double unseen = 1.0;
        for (const auto& [other, likely] : candidates[static_cast<std::size_t>(neighbor)]) {
            unseen -= likely;
            support += areConnected(curve, other) ? likely : 0.0;
        }
        support += std::max(0.0, unseen) * supportOfNone;
    }
    return support / static_cast<double>(neighbors.size());
}

void BranchMatcher::relaxCandidates(std::vector<Candidates>& candidates) const
{
    for (int round = 0; round < relaxations; ++round) {
        const std::vector<Candidates> before = candidates;
        for (std::size_t e = 0; e < candidates.size(); ++e) {
            double none = 1.0;
            double whole = 0.0;
            for (auto& [curve, probability] : candidates[e]) {
                none -= probability;
                probability *= ownWeight + supportOf(curve, neighbors_[e], before);
                whole += probability;
            }
            whole += std::max(0.0, none) * (ownWeight + supportOfNone);
            for (auto& [curve, probability] : candidates[e]) {
                probability /= std::max(whole, 1e-300);
            }
        }
    }
}

std::vector<int> BranchMatcher::match(const CentroidPose& pose, double reachPx) const
{
    BinGrid grid;
    grid.fill(problem_.target.points, visitedReaches * reachPx);
    std::vector<Candidates> candidates;
    candidates.reserve(tree_.edges.size());
    for (const BranchEdge& edge : tree_.edges) {
        candidates.push_back(candidatesOf(closenessOf(edge, pose, reachPx, grid)));
    }
    relaxCandidates(candidates);
    std::vector<int> matched;
    for (const Candidates& ofEdge : candidates) {
        double none = 1.0;
        double best = 0.0;
        int curve = noCurve;
        for (const auto& [candidate, probability] : ofEdge) {
            none -= probability;
            if (probability > best) {
                best = probability;
                curve = candidate;
            }
        }
        matched.push_back(best > none ? curve : noCurve);
    }
    return matched;
}

/// Returns the matched point on the curve; nullopt beyond the ends of the curve, which does not show the vessel there.
std::optional<Eigen::Vector2d> BranchMatcher::matchOnCurve(const ProjectedSample& sample, const CurveRange& curve,
                                                           double reachPx) const
{
    const TargetSamples& target = problem_.target;
    const auto distance = [&](std::size_t j) { return (target.points[j] - sample.pixel).squaredNorm(); };
    std::size_t nearest = curve.from;
    for (std::size_t j = curve.from + 1; j < curve.to; ++j) {
        nearest = distance(j) < distance(nearest) ? j : nearest;
    }
    const Eigen::Vector2d gap = target.points[nearest] - sample.pixel;
    const double along = std::abs(gap.dot(target.tangents[nearest]));
    const bool isEnd = nearest == curve.from || nearest + 1 == curve.to;
    if (gap.norm() > pairedReaches * reachPx ||
        std::abs(target.tangents[nearest].dot(sample.direction)) < minPairCosine ||
        (isEnd && along > std::max(1.0, 0.5 * gap.norm()))) {
        return {};
    }
    return target.points[nearest];
}

std::vector<BranchPair> BranchMatcher::pairs(const CentroidPose& pose, double reachPx) const
{
    const std::vector<int> matched = match(pose, reachPx);
    std::vector<BranchPair> pairs;
    for (std::size_t e = 0; e < matched.size(); ++e) {
        for (std::size_t i = tree_.edges[e].from; i < tree_.edges[e].to && matched[e] != noCurve; ++i) {
            const auto sample = projectSample(i, pose);
            const auto partner = sample ? matchOnCurve(*sample, curves_.at(matched[e]), reachPx) : std::nullopt;
            if (partner) {
                pairs.push_back({i, *partner});
            }
        }
    }
    return pairs;
}

}   // namespace angiopose::core
