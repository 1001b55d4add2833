#include "core/vessel/add_branch.h"

#include "core/messages/messages.h"
#include "core/vessel/edit_tree.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace angiopose::core {
namespace {

/// A point of a branch and its distance from a given position.
struct BranchPoint {
    const VesselBranch* branch = nullptr;
    std::size_t point = 0;
    double distanceMm = 0.0;
};

/// Returns the branch whose lumen contains the position or that touches it; of several, that with the nearest
/// centerline.
std::optional<BranchPoint> findSurroundingBranch(const VesselTree& tree, const Eigen::Vector3d& position)
{
    std::optional<BranchPoint> surrounding;
    for (const VesselBranch& branch : tree.branches) {
        const std::size_t point = nearestPoint(tree, branch.id, position);
        const double distanceMm = (branch.pointsInPatient[point] - position).norm();
        const double reachMm = (branch.radiusMm.size() == branch.pointsInPatient.size())
                                   ? std::max(branch.radiusMm[point], maxContactMm)
                                   : maxContactMm;
        if (distanceMm <= reachMm && (!surrounding || distanceMm < surrounding->distanceMm)) {
            surrounding = {&branch, point, distanceMm};
        }
    }
    return surrounding;
}

/// Removes the start of the branch that runs inside other branches; the branch then begins on the centerline of the
/// branch from which it emerges.
std::optional<BranchPoint> trimInside(const VesselTree& tree, VesselBranch& branch)
{
    std::optional<BranchPoint> last;
    std::size_t inside = 0;
    for (; inside < branch.pointsInPatient.size(); ++inside) {
        const auto surrounding = findSurroundingBranch(tree, branch.pointsInPatient[inside]);
        if (!surrounding) {
            break;
        }
        last = surrounding;
    }
    if (!last) {
        return {};
    }
    const auto count = static_cast<std::ptrdiff_t>(inside);
    branch.pointsInPatient.erase(branch.pointsInPatient.begin(), branch.pointsInPatient.begin() + count);
    if (branch.pointsInPatient.empty()) {
        return last;
    }
    branch.pointsInPatient.insert(branch.pointsInPatient.begin(), last->branch->pointsInPatient[last->point]);
    if (!branch.radiusMm.empty()) {
        branch.radiusMm.erase(branch.radiusMm.begin(), branch.radiusMm.begin() + count - 1);
        branch.radiusMm.front() = branch.radiusMm[1];
    }
    return last;
}

VesselBranch reverseDirection(VesselBranch branch)
{
    std::ranges::reverse(branch.pointsInPatient);
    std::ranges::reverse(branch.radiusMm);
    return branch;
}

}   // namespace

Result<VesselTree> attachBranch(const VesselTree& tree, VesselBranch branch)
{
    const auto parentAtStart = trimInside(tree, branch);
    if (branch.pointsInPatient.size() < 2) {
        return Error(messages::branchInsideTracedVessels());
    }
    branch = reverseDirection(std::move(branch));
    const auto parentAtEnd = trimInside(tree, branch);
    if (branch.pointsInPatient.size() < 2) {
        return Error(messages::branchInsideTracedVessels());
    }
    const auto generationOf = [](const std::optional<BranchPoint>& position) {
        return position && position->branch->generation >= 0 ? position->branch->generation
                                                             : std::numeric_limits<int>::max();
    };
    const bool startsAtEnd = parentAtEnd && (!parentAtStart || generationOf(parentAtEnd) < generationOf(parentAtStart));
    const std::optional<BranchPoint>& parent = startsAtEnd ? parentAtEnd : parentAtStart;
    if (!startsAtEnd) {
        branch = reverseDirection(std::move(branch));
    }
    branch.id = 1;
    for (const VesselBranch& other : tree.branches) {
        branch.id = std::max(branch.id, other.id + 1);
    }
    branch.generation = parent && parent->branch->generation >= 0 ? parent->branch->generation + 1 : -1;
    VesselTree result = tree;
    result.branches.push_back(std::move(branch));
    return result;
}

}   // namespace angiopose::core
