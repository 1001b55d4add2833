#include "core/registration/wire/likely_paths.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace angiopose::core {
namespace {

constexpr std::size_t maxEntries = 8;
constexpr std::size_t noKnot = std::numeric_limits<std::size_t>::max();

using KnotNeighbors = std::vector<std::vector<std::size_t>>;

KnotNeighbors neighborsOf(const TreeKnots& knots)
{
    KnotNeighbors neighbors(knots.size());
    for (const auto* links : {&knots.links, &knots.cuts}) {
        for (const KnotLink& link : *links) {
            neighbors[link.parent].push_back(link.child);
            neighbors[link.child].push_back(link.parent);
        }
    }
    return neighbors;
}

/// Returns the widest ends of the tree, widest first.
std::vector<std::size_t> entriesOf(const TreeKnots& knots, const KnotNeighbors& neighbors)
{
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k < knots.size(); ++k) {
        if (neighbors[k].size() == 1) {
            ends.push_back(k);
        }
    }
    std::ranges::stable_sort(ends, std::ranges::greater(), [&](std::size_t k) { return knots.radiusMm[k]; });
    ends.resize(std::min(ends.size(), maxEntries));
    return ends;
}

/// Knots reachable from an entry, each after its predecessor; loops are entered along their shorter side.
struct ReachableKnots {
    std::vector<std::size_t> knots;
    std::vector<std::size_t> before;   ///< index in `knots` of the predecessor; noKnot for the entry
};

ReachableKnots knotsReachableFrom(std::size_t entry, const KnotNeighbors& neighbors)
{
    ReachableKnots reachable{{entry}, {noKnot}};
    std::vector<std::uint8_t> isReached(neighbors.size(), 0);
    isReached[entry] = 1;
    for (std::size_t at = 0; at < reachable.knots.size(); ++at) {
        for (const std::size_t next : neighbors[reachable.knots[at]]) {
            if (isReached[next] == 0) {
                isReached[next] = 1;
                reachable.knots.push_back(next);
                reachable.before.push_back(at);
            }
        }
    }
    return reachable;
}

/// Partial alignment, represented by its cost and its start in the tree.
struct PathCell {
    float cost = std::numeric_limits<float>::infinity();
    std::uint32_t start = 0;
};

struct PathTip {
    std::size_t at = 0;   ///< knot of the wire tip, index in ReachableKnots
    std::size_t start = 0;
    double cost = std::numeric_limits<double>::infinity();
};

/// Aligns a curve with all paths from one entry at once, sharing their common beginnings.
class PathTable {
public:
    PathTable(const ReachableKnots& reachable, const ProjectedKnots& projected, const WireCurve& curve,
              const WireModel& model)
        : reachable_(reachable),
          projected_(projected),
          curve_(curve),
          model_(model),
          cells_(reachable.knots.size() * curve.size())
    {
        for (std::size_t at = 0; at < reachable_.knots.size(); ++at) {
            fillRow(at);
        }
    }

    /// Returns the best alignment that ends at this knot.
    PathTip tipAt(std::size_t at) const
    {
        PathTip tip{at};
        for (std::size_t k = 0; k < curve_.size(); ++k) {
            const double cost = cell(at, k).cost + skipped(curve_.lengthPx() - curve_.alongPx[k]);
            if (cost < tip.cost) {
                tip.cost = cost;
                tip.start = cell(at, k).start;
            }
        }
        return tip;
    }

private:
    double skipped(double lengthPx) const { return model_.skipPerMm * lengthPx * projected_.mmPerPx; }

    void fillRow(std::size_t at)
    {
        constexpr std::size_t maxMoveKnots = 3;   // maximum number of knots per move
        std::array<std::size_t, maxMoveKnots + 1> from{at, noKnot, noKnot, noKnot};
        std::array<Eigen::Vector2d, maxMoveKnots + 1> steps;
        const std::size_t knot = reachable_.knots[at];
        for (std::size_t back = 0; back <= maxMoveKnots && from[back] != noKnot; ++back) {
            steps[back] = projected_.pixels[knot] - projected_.pixels[reachable_.knots[from[back]]];
            if (back < maxMoveKnots) {
                from[back + 1] = reachable_.before[from[back]];
            }
        }
        const double scale = projected_.mmPerPx * projected_.mmPerPx;
        const double variance = model_.varianceMm2(projected_.radiusMm[knot]);
        for (std::size_t k = 0; k < curve_.size(); ++k) {
            const double squaredMm2 = scale * (projected_.pixels[knot] - curve_.pointsPx[k]).squaredNorm();
            if (!model_.isNearAxis(squaredMm2, variance)) {
                continue;
            }
            const double perMm = model_.positionCostPerMm(squaredMm2, variance);
            PathCell best{static_cast<float>(skipped(curve_.alongPx[k])), static_cast<std::uint32_t>(at)};
            for (const WireMove& move : wireMoves) {
                if (from[move.knots] == noKnot || k < move.points) {
                    continue;
                }
                const PathCell& before = cell(from[move.knots], k - move.points);
                if (before.cost >= best.cost) {
                    continue;
                }
                const StepCost step = stepCost(model_, steps[move.knots], curve_, k, move.points, projected_.mmPerPx);
                const float sum = before.cost + static_cast<float>(step.cost + perMm * step.lengthMm);
                best = sum < best.cost ? PathCell{sum, before.start} : best;
            }
            cells_[at * curve_.size() + k] = best;
        }
    }

    const PathCell& cell(std::size_t at, std::size_t k) const { return cells_[at * curve_.size() + k]; }

    const ReachableKnots& reachable_;
    const ProjectedKnots& projected_;
    const WireCurve& curve_;
    const WireModel& model_;
    std::vector<PathCell> cells_;
};

/// Returns the path from the entry to the tip, extended to the end of the tip's branch.
std::vector<std::size_t> pathThrough(const TreeKnots& knots, const ReachableKnots& reachable, std::size_t tip)
{
    std::vector<std::size_t> path;
    for (std::size_t at = tip; at != noKnot; at = reachable.before[at]) {
        path.push_back(reachable.knots[at]);
    }
    std::ranges::reverse(path);
    const std::size_t branch = knots.branchOf(path.back());
    for (std::size_t at = tip + 1; at < reachable.knots.size(); ++at) {
        if (reachable.knots[reachable.before[at]] == path.back() && knots.branchOf(reachable.knots[at]) == branch) {
            path.push_back(reachable.knots[at]);
        }
    }
    return path;
}

using EndBranches = std::pair<std::size_t, std::size_t>;

EndBranches endBranchesOf(const TreeKnots& knots, const ReachableKnots& reachable, const PathTip& tip)
{
    const std::size_t a = knots.branchOf(reachable.knots[tip.start]);
    const std::size_t b = knots.branchOf(reachable.knots[tip.at]);
    return {std::min(a, b), std::max(a, b)};
}

}   // namespace

std::vector<TreePath> findLikelyPaths(const TreeKnots& knots, const ProjectedKnots& projected, const WireCurve& curve,
                                      const WireModel& model, std::size_t maxPaths,
                                      const std::function<bool()>& shouldContinue)
{
    const KnotNeighbors neighbors = neighborsOf(knots);
    const WireCurve reversedCurve = reversed(curve);
    std::map<EndBranches, TreePath> best;
    for (const std::size_t entry : entriesOf(knots, neighbors)) {
        if (!shouldContinue()) {
            break;
        }
        const ReachableKnots reachable = knotsReachableFrom(entry, neighbors);
        for (const bool isReversed : {false, true}) {
            const PathTable table(reachable, projected, isReversed ? reversedCurve : curve, model);
            std::map<EndBranches, PathTip> tips;
            for (std::size_t at = 0; at < reachable.knots.size(); ++at) {
                const PathTip tip = table.tipAt(at);
                if (tip.cost == std::numeric_limits<double>::infinity()) {
                    continue;   // the knot is far from the wire
                }
                PathTip& known = tips[endBranchesOf(knots, reachable, tip)];
                known = tip.cost < known.cost ? tip : known;
            }
            for (const auto& [ends, tip] : tips) {
                const auto known = best.find(ends);
                if (known == best.end() || tip.cost < known->second.cost) {
                    best[ends] = {pathThrough(knots, reachable, tip.at), isReversed, tip.cost};
                }
            }
        }
    }
    std::vector<TreePath> paths;
    for (auto& [ends, path] : best) {
        paths.push_back(std::move(path));
    }
    std::ranges::stable_sort(paths, {}, &TreePath::cost);
    paths.resize(std::min(paths.size(), maxPaths));
    return paths;
}

}   // namespace angiopose::core
