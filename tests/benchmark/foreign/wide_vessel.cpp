#include "tests/benchmark/foreign/wide_vessel.h"

#include <algorithm>

namespace angiopose::benchmarks {
namespace {

constexpr double maxWideMm = 120.0;   // maximum length
constexpr double minWideMm = 60.0;
constexpr double radiusAtInflowMm = 2.5;
constexpr double radiusAtEndMm = 2.0;
constexpr double finestMm = 0.4;
constexpr double minFineMm = 0.8;   // maximum radius of the thin branches

double radiusOf(const RootedTree& tree, std::size_t branch)
{
    const std::vector<double>& radii = tree.tree.branches[branch].radiusMm;
    return radii.empty() ? 0.0 : radii.front();
}

/// Follows the widest branch from an inflow; of equally wide ones, the one that feeds the longest subtree.
std::vector<std::size_t> widestWay(const RootedTree& tree, std::size_t inflow)
{
    std::vector<std::size_t> way{inflow};
    const auto isBetter = [&](std::size_t a, std::size_t b) {
        return std::pair(radiusOf(tree, a), tree.lengthMm(tree.fedThrough(a))) >
               std::pair(radiusOf(tree, b), tree.lengthMm(tree.fedThrough(b)));
    };
    while (tree.lengthMm(way) < minWideMm) {
        std::vector<std::size_t> children;
        for (std::size_t branch = 0; branch < tree.parent.size(); ++branch) {
            if (tree.parent[branch] == static_cast<int>(way.back())) {
                children.push_back(branch);
            }
        }
        if (children.empty()) {
            break;
        }
        way.push_back(*std::ranges::min_element(children, isBetter));
    }
    return way;
}

/// The path closest to the wanted length; of those that are long enough, the widest.
std::vector<std::size_t> wideVesselOf(const RootedTree& tree)
{
    std::vector<std::size_t> best;
    for (std::size_t branch = 0; branch < tree.parent.size(); ++branch) {
        if (tree.parent[branch] >= 0) {
            continue;
        }
        std::vector<std::size_t> way = widestWay(tree, branch);
        const auto merit = [&](const std::vector<std::size_t>& one) {
            const double lengthMm = one.empty() ? 0.0 : tree.lengthMm(one);
            return std::pair(std::min(minWideMm, lengthMm), one.empty() ? 0.0 : radiusOf(tree, one.front()));
        };
        if (merit(way) > merit(best)) {
            best = std::move(way);
        }
    }
    while (best.size() > 1 && tree.lengthMm(best) > maxWideMm) {
        best.pop_back();
    }
    return best;
}

}   // namespace

WideVesselTree withWideVessel(const RootedTree& tree)
{
    WideVesselTree result{tree, wideVesselOf(tree), {}};
    const auto isWide = [&](std::size_t branch) { return std::ranges::find(result.wide, branch) != result.wide.end(); };
    double widestMm = 0.0;
    for (std::size_t branch = 0; branch < tree.parent.size(); ++branch) {
        widestMm = std::max(widestMm, isWide(branch) ? 0.0 : radiusOf(tree, branch));
    }
    for (std::size_t branch = 0; branch < tree.parent.size(); ++branch) {
        if (isWide(branch)) {
            continue;
        }
        const double share = widestMm > 0.0 ? radiusOf(tree, branch) / widestMm : 0.0;
        core::VesselBranch& vessel = result.tree.tree.branches[branch];
        vessel.radiusMm.assign(vessel.pointsInPatient.size(), finestMm + (minFineMm - finestMm) * share);
        if (tree.parent[branch] >= 0 && isWide(static_cast<std::size_t>(tree.parent[branch]))) {
            result.beside.push_back(branch);
        }
    }
    const double wholeMm = tree.lengthMm(result.wide);
    double alongMm = 0.0;
    for (const std::size_t branch : result.wide) {
        core::VesselBranch& vessel = result.tree.tree.branches[branch];
        for (std::size_t i = 0; i < vessel.pointsInPatient.size(); ++i) {
            alongMm += i > 0 ? (vessel.pointsInPatient[i] - vessel.pointsInPatient[i - 1]).norm() : 0.0;
            vessel.radiusMm[i] = radiusAtInflowMm - (radiusAtInflowMm - radiusAtEndMm) * alongMm / wholeMm;
        }
    }
    return result;
}

}   // namespace angiopose::benchmarks
