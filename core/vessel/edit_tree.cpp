#include "core/vessel/edit_tree.h"

#include "core/messages/messages.h"
#include "core/vessel/polyline.h"
#include "core/vessel/smoothing_spline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

namespace angiopose::core {
namespace {

Error noSuchBranch(int branchId)
{
    return messages::noSuchBranch(branchId);
}

VesselBranch* findBranch(VesselTree& tree, int branchId)
{
    const auto found = std::find_if(tree.branches.begin(), tree.branches.end(),
                                    [&](const VesselBranch& branch) { return branch.id == branchId; });
    return found == tree.branches.end() ? nullptr : &*found;
}

bool touches(const VesselBranch& branch, const Eigen::Vector3d& point)
{
    return std::any_of(branch.pointsInPatient.begin(), branch.pointsInPatient.end(),
                       [&](const Eigen::Vector3d& other) { return (other - point).norm() <= maxContactMm; });
}

int nextFreeId(const VesselTree& tree)
{
    int largest = 0;
    for (const VesselBranch& branch : tree.branches) {
        largest = std::max(largest, branch.id);
    }
    return largest + 1;
}

bool hasRadii(const VesselBranch& branch)
{
    return branch.radiusMm.size() == branch.pointsInPatient.size();
}

double meanRadius(const VesselBranch& branch)
{
    return std::accumulate(branch.radiusMm.begin(), branch.radiusMm.end(), 0.0) /
           static_cast<double>(branch.radiusMm.size());
}

/// Returns whether no other branch begins on this branch beyond its first points.
bool isEndBranch(const VesselTree& tree, const VesselBranch& branch)
{
    return std::none_of(tree.branches.begin(), tree.branches.end(), [&](const VesselBranch& other) {
        const Eigen::Vector3d& start = other.pointsInPatient.front();
        return other.id != branch.id && touches(branch, start) &&
               (start - branch.pointsInPatient.front()).norm() > maxContactMm;
    });
}

/// Returns the shortest end branch that is too short or too thin.
std::optional<int> worstEndBranch(const VesselTree& tree, double minLengthMm, double minRadiusMm)
{
    std::optional<int> worst;
    double shortest = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        const double length = branch.lengthMm();
        const bool isThin = hasRadii(branch) && meanRadius(branch) < minRadiusMm;
        if ((length < minLengthMm || isThin) && isEndBranch(tree, branch) && (!worst || length < shortest)) {
            worst = branch.id;
            shortest = length;
        }
    }
    return worst;
}

VesselBranch reversedBranch(VesselBranch branch)
{
    std::reverse(branch.pointsInPatient.begin(), branch.pointsInPatient.end());
    std::reverse(branch.radiusMm.begin(), branch.radiusMm.end());
    return branch;
}

const Eigen::Vector3d& endOf(const VesselBranch& branch, bool isLastPoint)
{
    return isLastPoint ? branch.pointsInPatient.back() : branch.pointsInPatient.front();
}

/// Extends the branch along a straight line toward `to`, with the point spacing of the branch.
void bridge(VesselBranch& branch, const Eigen::Vector3d& to, std::optional<double> radiusAtEnd)
{
    const Eigen::Vector3d from = branch.pointsInPatient.back();
    const double spacing = branch.lengthMm() / static_cast<double>(branch.pointsInPatient.size() - 1);
    const auto steps = static_cast<int>(std::floor((to - from).norm() / std::max(spacing, 1e-3)));
    const double radius = radiusAtEnd ? branch.radiusMm.back() : 0.0;
    for (int step = 1; step < steps; ++step) {
        const double fraction = static_cast<double>(step) / steps;
        branch.pointsInPatient.emplace_back(from + fraction * (to - from));
        if (radiusAtEnd) {
            branch.radiusMm.push_back((1.0 - fraction) * radius + fraction * *radiusAtEnd);
        }
    }
}

}   // namespace

Result<VesselTree> removeSubtree(const VesselTree& tree, int branchId)
{
    if (tree.find(branchId) == nullptr) {
        return noSuchBranch(branchId);
    }
    std::set<int> removedIds{branchId};
    for (bool hasGrown = true; hasGrown;) {
        hasGrown = false;
        for (const VesselBranch& branch : tree.branches) {
            const bool startsOnRemoved = std::any_of(removedIds.begin(), removedIds.end(), [&](int id) {
                const VesselBranch& parent = *tree.find(id);
                const Eigen::Vector3d& start = branch.pointsInPatient.front();
                return touches(parent, start) && (start - parent.pointsInPatient.front()).norm() > maxContactMm;
            });
            if (!removedIds.contains(branch.id) && startsOnRemoved) {
                hasGrown = removedIds.insert(branch.id).second;
            }
        }
    }
    if (removedIds.size() == tree.branches.size()) {
        return Error(messages::allDescendFromBranch(branchId));
    }
    return withoutBranches(tree, {removedIds.begin(), removedIds.end()});
}

Result<VesselTree> pruneTree(const VesselTree& tree, double minLengthMm, double minRadiusMm)
{
    VesselTree result = tree;
    while (const auto worst = worstEndBranch(result, minLengthMm, minRadiusMm)) {
        result = withoutBranches(result, {*worst});
    }
    if (result.branches.empty()) {
        return Error(messages::allPruned());
    }
    return result;
}

Result<VesselTree> splitAt(const VesselTree& tree, int branchId, std::size_t point)
{
    VesselTree result = tree;
    VesselBranch* first = findBranch(result, branchId);
    if (first == nullptr) {
        return noSuchBranch(branchId);
    }
    if (point < 1 || point + 3 > first->pointsInPatient.size()) {
        return Error(messages::cutTooNearEnd(branchId));
    }
    const auto at = static_cast<std::ptrdiff_t>(point) + 1;
    VesselBranch second{nextFreeId(tree),
                        "",
                        {first->pointsInPatient.begin() + at, first->pointsInPatient.end()},
                        {},
                        first->generation};
    first->pointsInPatient.resize(point + 1);
    if (!first->radiusMm.empty()) {
        second.radiusMm.assign(first->radiusMm.begin() + at, first->radiusMm.end());
        first->radiusMm.resize(point + 1);
    }
    result.branches.push_back(std::move(second));
    return result;
}

Result<VesselTree> joinBranches(const VesselTree& tree, int firstId, int secondId)
{
    const VesselBranch* first = tree.find(firstId);
    const VesselBranch* second = tree.find(secondId);
    if (first == nullptr || second == nullptr) {
        return noSuchBranch(first == nullptr ? firstId : secondId);
    }
    BranchEnd from{firstId, true};
    BranchEnd to{secondId, false};
    double shortest = std::numeric_limits<double>::infinity();
    for (const bool firstBack : {true, false}) {
        for (const bool secondBack : {false, true}) {
            const double distance = (endOf(*first, firstBack) - endOf(*second, secondBack)).norm();
            if (distance < shortest) {
                shortest = distance;
                from.isLastPoint = firstBack;
                to.isLastPoint = secondBack;
            }
        }
    }
    return joinAtEnds(tree, from, to);
}

Result<VesselTree> joinAtEnds(const VesselTree& tree, const BranchEnd& first, const BranchEnd& second)
{
    if (tree.find(first.branchId) == nullptr || tree.find(second.branchId) == nullptr) {
        return noSuchBranch(tree.find(first.branchId) == nullptr ? first.branchId : second.branchId);
    }
    if (first.branchId == second.branchId) {
        return Error(messages::joinedToItself());
    }
    VesselTree result = withoutBranches(tree, {second.branchId});
    VesselBranch& stays = *findBranch(result, first.branchId);
    VesselBranch whole = first.isLastPoint ? stays : reversedBranch(stays);
    VesselBranch other = *tree.find(second.branchId);
    other = second.isLastPoint ? reversedBranch(std::move(other)) : std::move(other);
    const bool bothHaveRadii = hasRadii(whole) && hasRadii(other);
    if (!bothHaveRadii) {
        whole.radiusMm.clear();
        other.radiusMm.clear();
    }
    bridge(whole, other.pointsInPatient.front(),
           bothHaveRadii ? std::optional<double>(other.radiusMm.front()) : std::nullopt);
    const double step = (whole.pointsInPatient.back() - other.pointsInPatient.front()).norm();
    const std::ptrdiff_t skip = step < 1e-6 ? 1 : 0;
    whole.pointsInPatient.insert(whole.pointsInPatient.end(), other.pointsInPatient.begin() + skip,
                                 other.pointsInPatient.end());
    if (bothHaveRadii) {
        whole.radiusMm.insert(whole.radiusMm.end(), other.radiusMm.begin() + skip, other.radiusMm.end());
    }
    stays = first.isLastPoint ? std::move(whole) : reversedBranch(std::move(whole));
    return result;
}

Result<VesselTree> extendBranchTo(const VesselTree& tree, const BranchEnd& end, const Eigen::Vector3d& pointInPatient)
{
    VesselTree result = tree;
    VesselBranch* branch = findBranch(result, end.branchId);
    if (branch == nullptr) {
        return noSuchBranch(end.branchId);
    }
    VesselBranch longer = end.isLastPoint ? *branch : reversedBranch(*branch);
    const bool hasKnownRadii = hasRadii(longer);
    bridge(longer, pointInPatient, hasKnownRadii ? std::optional(longer.radiusMm.back()) : std::nullopt);
    longer.pointsInPatient.push_back(pointInPatient);
    if (hasKnownRadii) {
        longer.radiusMm.push_back(longer.radiusMm.back());
    }
    *branch = end.isLastPoint ? std::move(longer) : reversedBranch(std::move(longer));
    return result;
}

std::size_t nearestPoint(const VesselTree& tree, int branchId, const Eigen::Vector3d& pointInPatient)
{
    const auto& points = tree.find(branchId)->pointsInPatient;
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
        return (a - pointInPatient).squaredNorm() < (b - pointInPatient).squaredNorm();
    });
    return static_cast<std::size_t>(nearest - points.begin());
}

Result<VesselTree> smoothBranch(const VesselTree& tree, int branchId, double widthMm)
{
    VesselTree result = tree;
    VesselBranch* branch = findBranch(result, branchId);
    if (branch == nullptr) {
        return noSuchBranch(branchId);
    }
    const std::size_t count = branch->pointsInPatient.size();
    const double spacing = branch->lengthMm() / static_cast<double>(std::max<std::size_t>(1, count - 1));
    if (count < 3 || !(spacing > 0.0)) {
        return result;
    }
    // The spline halves the amplitude of a wave whose length is 2π λ^¼ times the point spacing.
    const double lambda = std::pow(widthMm / (2.0 * std::numbers::pi * spacing), 4.0);
    std::vector<double> weights(count, 1.0);
    weights.front() = 1e6;
    weights.back() = 1e6;
    branch->pointsInPatient = smoothSpline(branch->pointsInPatient, weights, lambda);
    branch->pointsInPatient.front() = tree.find(branchId)->pointsInPatient.front();
    branch->pointsInPatient.back() = tree.find(branchId)->pointsInPatient.back();
    return result;
}

Result<VesselTree> renameBranch(const VesselTree& tree, int branchId, const std::string& name)
{
    VesselTree result = tree;
    VesselBranch* branch = findBranch(result, branchId);
    if (branch == nullptr) {
        return noSuchBranch(branchId);
    }
    branch->name = name;
    return result;
}

Result<VesselTree> assignGeneration(const VesselTree& tree, int branchId, int generation)
{
    VesselTree result = tree;
    VesselBranch* branch = findBranch(result, branchId);
    if (branch == nullptr) {
        return noSuchBranch(branchId);
    }
    branch->generation = std::max(-1, generation);
    return result;
}

}   // namespace angiopose::core
