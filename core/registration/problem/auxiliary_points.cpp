#include "core/registration/problem/auxiliary_points.h"

#include "core/support/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr double mainShare = 1.0 / 3.0;

std::vector<int> pointsOfBranches(const TreeSamples& tree, const std::vector<std::uint8_t>& isTaken)
{
    std::vector<int> points;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        if (isTaken[static_cast<std::size_t>(tree.branchIndex[i])] != 0) {
            points.push_back(static_cast<int>(i));
        }
    }
    return points;
}

std::vector<int> chosenBranches(const TreeSamples& tree, const std::vector<int>& branchIds)
{
    std::vector<std::uint8_t> isTaken(tree.branchIds.size(), 0);
    for (std::size_t b = 0; b < isTaken.size(); ++b) {
        const bool isChosen = std::find(branchIds.begin(), branchIds.end(), tree.branchIds[b]) != branchIds.end();
        isTaken[b] = isChosen ? 1 : 0;
    }
    return pointsOfBranches(tree, isTaken);
}

std::vector<int> nodes(const TreeSamples& tree)
{
    std::vector<int> points;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        if (tree.isNode[i] != 0) {
            points.push_back(static_cast<int>(i));
        }
    }
    return points;
}

/// Returns the widest branches, or the longest if no radius is known, up to a third of the points.
std::vector<int> mainBranches(const TreeSamples& tree)
{
    const std::size_t count = tree.branchIds.size();
    std::vector<double> pointCount(count, 0.0);
    std::vector<double> radiusSum(count, 0.0);
    for (std::size_t i = 0; i < tree.size(); ++i) {
        pointCount[static_cast<std::size_t>(tree.branchIndex[i])] += 1.0;
        radiusSum[static_cast<std::size_t>(tree.branchIndex[i])] += tree.radiusMm[i];
    }
    std::vector<double> rank = pointCount;
    for (std::size_t b = 0; tree.hasRadius() && b < count; ++b) {
        rank[b] = radiusSum[b] / std::max(1.0, pointCount[b]);
    }
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank[a] > rank[b]; });

    std::vector<std::uint8_t> isTaken(count, 0);
    double taken = 0.0;
    for (const std::size_t b : order) {
        if (taken >= mainShare * static_cast<double>(tree.size())) {
            break;
        }
        isTaken[b] = 1;
        taken += pointCount[b];
    }
    return pointsOfBranches(tree, isTaken);
}

std::vector<int> randomPoints(const TreeSamples& tree, int count, std::uint64_t seed)
{
    std::vector<int> points(tree.size());
    std::iota(points.begin(), points.end(), 0);
    CounterRandom random(seed);
    const std::size_t wanted = std::min(points.size(), static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < wanted; ++i) {
        std::swap(points[i], points[i + static_cast<std::size_t>(random.index(static_cast<int>(points.size() - i)))]);
    }
    points.resize(wanted);
    std::sort(points.begin(), points.end());
    return points;
}

}   // namespace

std::vector<int> auxiliaryPoints(const TreeSamples& tree, const std::vector<int>& branchIds,
                                 const RegistrationOptions& options)
{
    switch (options.seed.auxiliary) {
        case AuxiliarySet::Chosen:
            return branchIds.empty() ? nodes(tree) : chosenBranches(tree, branchIds);
        case AuxiliarySet::Nodes:
            return nodes(tree);
        case AuxiliarySet::MainBranches:
            return mainBranches(tree);
        case AuxiliarySet::Random:
            return randomPoints(tree, options.seed.auxiliaryCount, static_cast<std::uint64_t>(options.randomSeed));
    }
    return {};
}

}   // namespace angiopose::core
