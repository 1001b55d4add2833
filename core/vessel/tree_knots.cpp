#include "core/vessel/tree_knots.h"

#include "core/vessel/polyline.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr double minLinkMm = 0.5;   // minimum length of a link; ends that meet may coincide or leave a gap

struct KnotPair {
    std::size_t a = 0;
    std::size_t b = 0;
};

std::size_t nearestKnotOf(const TreeKnots& knots, std::size_t branch, const Eigen::Vector3d& place)
{
    std::size_t nearest = knots.firstOfBranch[branch];
    for (std::size_t k = nearest; k < knots.firstOfBranch[branch + 1]; ++k) {
        if ((knots.positions[k] - place).squaredNorm() < (knots.positions[nearest] - place).squaredNorm()) {
            nearest = k;
        }
    }
    return nearest;
}

/// Returns the pairs of neighboring knots, along the branches and where branches meet.
std::vector<KnotPair> neighborPairs(const VesselTree& tree, const TreeKnots& knots)
{
    std::vector<KnotPair> pairs;
    for (std::size_t b = 0; b + 1 < knots.firstOfBranch.size(); ++b) {
        for (std::size_t k = knots.firstOfBranch[b]; k + 1 < knots.firstOfBranch[b + 1]; ++k) {
            pairs.push_back({k, k + 1});
        }
    }
    const auto branchNumber = [&](int id) {
        const auto found = std::ranges::find(tree.branches, id, &VesselBranch::id);
        return static_cast<std::size_t>(found - tree.branches.begin());
    };
    for (const VesselNode& node : findNodes(tree)) {
        for (std::size_t i = 1; i < node.branchIds.size(); ++i) {
            pairs.push_back({nearestKnotOf(knots, branchNumber(node.branchIds.front()), node.pointInPatient),
                             nearestKnotOf(knots, branchNumber(node.branchIds[i]), node.pointInPatient)});
        }
    }
    return pairs;
}

/// Returns the links of a spanning forest, directed away from the first knot of each component.
std::vector<KnotLink> linkForest(const TreeKnots& knots, const std::vector<KnotPair>& pairs)
{
    std::vector<std::vector<std::size_t>> neighbors(knots.size());
    for (const KnotPair& pair : pairs) {
        neighbors[pair.a].push_back(pair.b);
        neighbors[pair.b].push_back(pair.a);
    }
    std::vector<KnotLink> links;
    std::vector<std::uint8_t> isReached(knots.size(), 0);
    std::vector<std::size_t> waiting;
    for (std::size_t root = 0; root < knots.size(); ++root) {
        if (isReached[root] != 0) {
            continue;
        }
        isReached[root] = 1;
        waiting.assign(1, root);
        for (std::size_t w = 0; w < waiting.size(); ++w) {
            const std::size_t parent = waiting[w];
            for (const std::size_t child : neighbors[parent]) {
                if (isReached[child] == 0) {
                    isReached[child] = 1;
                    waiting.push_back(child);
                    const double distanceMm = (knots.positions[child] - knots.positions[parent]).norm();
                    links.push_back({parent, child, std::max(minLinkMm, distanceMm)});
                }
            }
        }
    }
    return links;
}

void addBranch(const VesselBranch& branch, bool isUsed, double spacingMm, TreeKnots& knots)
{
    const std::vector<PolylineStation> stations = evenStations<3>(branch.pointsInPatient, spacingMm);
    const std::vector<Eigen::Vector3d> tangents = interpolate(tangentsOf(branch.pointsInPatient), stations);
    const std::vector<Eigen::Vector3d> positions = interpolate(branch.pointsInPatient, stations);
    const bool isWidthKnown = !branch.radiusMm.empty();
    std::vector<double> radii = isWidthKnown ? interpolate(branch.radiusMm, stations) : std::vector<double>();
    radii.resize(positions.size(), 0.0);
    knots.radiusMm.insert(knots.radiusMm.end(), radii.begin(), radii.end());
    const double step = branch.lengthMm() / static_cast<double>(std::max<std::size_t>(1, positions.size() - 1));
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const bool isEnd = k == 0 || k + 1 == positions.size();
        knots.positions.push_back(positions[k]);
        knots.tangents.push_back(tangents[k].normalized());
        knots.lengthMm.push_back(isEnd ? 0.5 * step : step);
        knots.isUsed.push_back(isUsed ? 1 : 0);
    }
    knots.firstOfBranch.push_back(knots.size());
}

/// Returns the pairs that are not links of the forest.
std::vector<KnotLink> findCutLinks(const TreeKnots& knots, const std::vector<KnotPair>& pairs)
{
    std::vector<std::size_t> parents(knots.size(), knots.size());
    for (const KnotLink& link : knots.links) {
        parents[link.child] = link.parent;
    }
    std::vector<KnotLink> cuts;
    for (const KnotPair& pair : pairs) {
        if (pair.a != pair.b && parents[pair.a] != pair.b && parents[pair.b] != pair.a) {
            const double distanceMm = (knots.positions[pair.a] - knots.positions[pair.b]).norm();
            cuts.push_back({pair.a, pair.b, std::max(minLinkMm, distanceMm)});
        }
    }
    return cuts;
}

}   // namespace

std::size_t TreeKnots::branchOf(std::size_t knot) const
{
    const auto after = std::upper_bound(firstOfBranch.begin(), firstOfBranch.end(), knot);
    return static_cast<std::size_t>(after - firstOfBranch.begin()) - 1;
}

Eigen::MatrixXd TreeKnots::distancesAlongTree() const
{
    const auto count = static_cast<Eigen::Index>(size());
    Eigen::MatrixXd distances = Eigen::MatrixXd::Constant(count, count, std::numeric_limits<double>::infinity());
    distances.diagonal().setZero();
    // Parents come before their children: all distances to the parent are known and give those to the child.
    for (std::size_t l = 0; l < links.size(); ++l) {
        const auto parent = static_cast<Eigen::Index>(links[l].parent);
        const auto child = static_cast<Eigen::Index>(links[l].child);
        distances.col(child) = distances.col(parent).array() + links[l].lengthMm;
        distances(child, child) = 0.0;
        distances.row(child) = distances.col(child).transpose();
    }
    return distances;
}

TreeKnots treeKnots(const VesselTree& tree, const std::vector<int>& excludedBranchIds, double spacingMm)
{
    TreeKnots knots;
    knots.firstOfBranch.push_back(0);
    for (const VesselBranch& branch : tree.branches) {
        addBranch(branch, std::ranges::count(excludedBranchIds, branch.id) == 0, spacingMm, knots);
    }
    const std::vector<KnotPair> pairs = neighborPairs(tree, knots);
    knots.links = linkForest(knots, pairs);
    knots.cuts = findCutLinks(knots, pairs);
    return knots;
}

}   // namespace angiopose::core
