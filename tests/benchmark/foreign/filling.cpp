#include "tests/benchmark/foreign/filling.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace angiopose::benchmarks {

std::vector<std::size_t> allOf(const RootedTree& tree)
{
    std::vector<std::size_t> all(tree.parent.size());
    for (std::size_t branch = 0; branch < all.size(); ++branch) {
        all[branch] = branch;
    }
    return all;
}

namespace {

/// A random subtree whose share of the tree's length lies within the limits, or the closest to them if there is none.
std::vector<std::size_t> territory(const RootedTree& tree, double least, double most, ForeignRandom& random)
{
    const double whole = tree.lengthMm(allOf(tree));
    std::vector<std::vector<std::size_t>> fitting;
    std::vector<std::size_t> nearest;
    double nearestOff = 2.0;
    for (std::size_t branch = 0; branch < tree.parent.size(); ++branch) {
        std::vector<std::size_t> fed = tree.fedThrough(branch);
        const double share = tree.lengthMm(fed) / whole;
        if (share >= least && share <= most) {
            fitting.push_back(fed);
        }
        if (const double off = std::abs(share - 0.5 * (least + most)); off < nearestOff) {
            nearestOff = off;
            nearest = std::move(fed);
        }
    }
    return fitting.empty() ? nearest : fitting[random.index(fitting.size())];
}

std::vector<std::size_t> twoTerritories(const RootedTree& tree, ForeignRandom& random)
{
    std::vector<std::size_t> both = territory(tree, 0.08, 0.3, random);
    for (int tries = 0; tries < 50; ++tries) {
        const std::vector<std::size_t> other = territory(tree, 0.08, 0.3, random);
        std::vector<std::size_t> common;
        std::set_intersection(both.begin(), both.end(), other.begin(), other.end(), std::back_inserter(common));
        if (common.empty()) {
            both.insert(both.end(), other.begin(), other.end());
            break;
        }
    }
    std::sort(both.begin(), both.end());
    return both;
}

std::vector<std::size_t> withoutLeaves(const RootedTree& tree, double share, ForeignRandom& random)
{
    std::vector<std::size_t> kept;
    for (const std::size_t branch : allOf(tree)) {
        if (!tree.isLeaf(branch) || random.uniform() >= share) {
            kept.push_back(branch);
        }
    }
    return kept;
}

std::vector<std::size_t> wayToAnEnd(const RootedTree& tree, ForeignRandom& random)
{
    std::size_t end = random.index(tree.parent.size());
    while (!tree.isLeaf(end)) {
        end = random.index(tree.parent.size());
    }
    std::vector<std::size_t> way;
    for (int at = static_cast<int>(end); at >= 0; at = tree.parent[static_cast<std::size_t>(at)]) {
        way.push_back(static_cast<std::size_t>(at));
    }
    return {way.rbegin(), way.rend()};
}

}   // namespace

std::vector<std::size_t> filledIn(const RootedTree& tree, ForeignScene scene, ForeignRandom& random)
{
    switch (scene) {
        case ForeignScene::OneTerritory:
        case ForeignScene::OtherTerritory:
            return territory(tree, 0.1, 0.5, random);
        case ForeignScene::TwoTerritories:
            return twoTerritories(tree, random);
        case ForeignScene::OneVessel:
            return wayToAnEnd(tree, random);
        case ForeignScene::LeavesMissing:
            return withoutLeaves(tree, 0.2, random);
        default:
            return allOf(tree);
    }
}

}   // namespace angiopose::benchmarks
