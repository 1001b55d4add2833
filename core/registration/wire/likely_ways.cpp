#include "core/registration/wire/likely_ways.h"

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
struct Outwards {
    std::vector<std::size_t> knots;
    std::vector<std::size_t> before;   ///< index in `knots` of the predecessor; noKnot for the entry
};

Outwards outwardsFrom(std::size_t entry, const KnotNeighbors& neighbors)
{
    Outwards outwards{{entry}, {noKnot}};
    std::vector<std::uint8_t> isReached(neighbors.size(), 0);
    isReached[entry] = 1;
    for (std::size_t at = 0; at < outwards.knots.size(); ++at) {
        for (const std::size_t next : neighbors[outwards.knots[at]]) {
            if (isReached[next] == 0) {
                isReached[next] = 1;
                outwards.knots.push_back(next);
                outwards.before.push_back(at);
            }
        }
    }
    return outwards;
}

/// Partial alignment, represented by its cost and its start in the tree.
struct WayCell {
    float cost = std::numeric_limits<float>::infinity();
    std::uint32_t start = 0;
};

struct WayTip {
    std::size_t at = 0;   ///< knot of the wire tip, index in Outwards
    std::size_t start = 0;
    double cost = std::numeric_limits<double>::infinity();
};

/// Aligns a curve with all paths from one entry at once, sharing their common beginnings.
class WayTable {
public:
    WayTable(const Outwards& outwards, const ObservedKnots& seen, const WireCurve& curve, const WireModel& model)
        : outwards_(outwards), seen_(seen), curve_(curve), model_(model), cells_(outwards.knots.size() * curve.size())
    {
        for (std::size_t at = 0; at < outwards_.knots.size(); ++at) {
            fillRow(at);
        }
    }

    /// Returns the best alignment that ends at this knot.
    WayTip tipAt(std::size_t at) const
    {
        WayTip tip{at};
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
    double skipped(double lengthPx) const { return model_.skipPerMm * lengthPx * seen_.mmPerPx; }

    void fillRow(std::size_t at)
    {
        constexpr std::size_t farthest = 3;   // maximum number of knots per move
        std::array<std::size_t, farthest + 1> from{at, noKnot, noKnot, noKnot};
        std::array<Eigen::Vector2d, farthest + 1> steps;
        const std::size_t knot = outwards_.knots[at];
        for (std::size_t back = 0; back <= farthest && from[back] != noKnot; ++back) {
            steps[back] = seen_.pixels[knot] - seen_.pixels[outwards_.knots[from[back]]];
            if (back < farthest) {
                from[back + 1] = outwards_.before[from[back]];
            }
        }
        const double scale = seen_.mmPerPx * seen_.mmPerPx;
        const double variance = model_.varianceMm2(seen_.radiusMm[knot]);
        for (std::size_t k = 0; k < curve_.size(); ++k) {
            const double squaredMm2 = scale * (seen_.pixels[knot] - curve_.pointsPx[k]).squaredNorm();
            if (!model_.isBeside(squaredMm2, variance)) {
                continue;
            }
            const double perMm = model_.placeCostPerMm(squaredMm2, variance);
            WayCell best{static_cast<float>(skipped(curve_.alongPx[k])), static_cast<std::uint32_t>(at)};
            for (const WireMove& move : wireMoves) {
                if (from[move.knots] == noKnot || k < move.points) {
                    continue;
                }
                const WayCell& before = cell(from[move.knots], k - move.points);
                if (before.cost >= best.cost) {
                    continue;
                }
                const ObservedStep step = seenStep(model_, steps[move.knots], curve_, k, move.points, seen_.mmPerPx);
                const float sum = before.cost + static_cast<float>(step.cost + perMm * step.lengthMm);
                best = sum < best.cost ? WayCell{sum, before.start} : best;
            }
            cells_[at * curve_.size() + k] = best;
        }
    }

    const WayCell& cell(std::size_t at, std::size_t k) const { return cells_[at * curve_.size() + k]; }

    const Outwards& outwards_;
    const ObservedKnots& seen_;
    const WireCurve& curve_;
    const WireModel& model_;
    std::vector<WayCell> cells_;
};

/// Returns the path from the entry to the tip, extended to the end of the tip's branch.
std::vector<std::size_t> wayThrough(const TreeKnots& knots, const Outwards& outwards, std::size_t tip)
{
    std::vector<std::size_t> way;
    for (std::size_t at = tip; at != noKnot; at = outwards.before[at]) {
        way.push_back(outwards.knots[at]);
    }
    std::ranges::reverse(way);
    const std::size_t branch = knots.branchOf(way.back());
    for (std::size_t at = tip + 1; at < outwards.knots.size(); ++at) {
        if (outwards.knots[outwards.before[at]] == way.back() && knots.branchOf(outwards.knots[at]) == branch) {
            way.push_back(outwards.knots[at]);
        }
    }
    return way;
}

using EndBranches = std::pair<std::size_t, std::size_t>;

EndBranches endBranchesOf(const TreeKnots& knots, const Outwards& outwards, const WayTip& tip)
{
    const std::size_t a = knots.branchOf(outwards.knots[tip.start]);
    const std::size_t b = knots.branchOf(outwards.knots[tip.at]);
    return {std::min(a, b), std::max(a, b)};
}

}   // namespace

std::vector<TreeWay> likelyWays(const TreeKnots& knots, const ObservedKnots& seen, const WireCurve& curve,
                                const WireModel& model, std::size_t most, const std::function<bool()>& shouldContinue)
{
    const KnotNeighbors neighbors = neighborsOf(knots);
    const WireCurve turned = reversed(curve);
    std::map<EndBranches, TreeWay> best;
    for (const std::size_t entry : entriesOf(knots, neighbors)) {
        if (!shouldContinue()) {
            break;
        }
        const Outwards outwards = outwardsFrom(entry, neighbors);
        for (const bool isTurned : {false, true}) {
            const WayTable table(outwards, seen, isTurned ? turned : curve, model);
            std::map<EndBranches, WayTip> tips;
            for (std::size_t at = 0; at < outwards.knots.size(); ++at) {
                const WayTip tip = table.tipAt(at);
                if (tip.cost == std::numeric_limits<double>::infinity()) {
                    continue;   // the knot is far from the wire
                }
                WayTip& known = tips[endBranchesOf(knots, outwards, tip)];
                known = tip.cost < known.cost ? tip : known;
            }
            for (const auto& [ends, tip] : tips) {
                const auto known = best.find(ends);
                if (known == best.end() || tip.cost < known->second.cost) {
                    best[ends] = {wayThrough(knots, outwards, tip.at), isTurned, tip.cost};
                }
            }
        }
    }
    std::vector<TreeWay> ways;
    for (auto& [ends, way] : best) {
        ways.push_back(std::move(way));
    }
    std::ranges::stable_sort(ways, {}, &TreeWay::cost);
    ways.resize(std::min(ways.size(), most));
    return ways;
}

}   // namespace angiopose::core
