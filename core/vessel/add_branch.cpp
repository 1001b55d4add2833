#include "core/vessel/add_branch.h"

#include "core/messages/messages.h"
#include "core/vessel/edit_tree.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace angiopose::core {
namespace {

/// A point of a branch and its distance from a given position.
struct PlaceInBranch {
    const VesselBranch* branch = nullptr;
    std::size_t point = 0;
    double awayMm = 0.0;
};

/// Returns the branch whose lumen contains the position or that touches it; if there are several, the one with the
/// nearest axis.
std::optional<PlaceInBranch> branchAround(const VesselTree& tree, const Eigen::Vector3d& place)
{
    std::optional<PlaceInBranch> around;
    for (const VesselBranch& branch : tree.branches) {
        const std::size_t point = nearestPoint(tree, branch.id, place);
        const double awayMm = (branch.pointsInPatient[point] - place).norm();
        const double reachMm = (branch.radiusMm.size() == branch.pointsInPatient.size())
                                   ? std::max(branch.radiusMm[point], touchingMm)
                                   : touchingMm;
        if (awayMm <= reachMm && (!around || awayMm < around->awayMm)) {
            around = {&branch, point, awayMm};
        }
    }
    return around;
}

/// Removes the start of the branch that runs inside other branches; the branch then begins on the axis of the branch
/// from which it emerges.
std::optional<PlaceInBranch> trimInside(const VesselTree& tree, VesselBranch& branch)
{
    std::optional<PlaceInBranch> last;
    std::size_t inside = 0;
    for (; inside < branch.pointsInPatient.size(); ++inside) {
        const auto around = branchAround(tree, branch.pointsInPatient[inside]);
        if (!around) {
            break;
        }
        last = around;
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

VesselBranch turnedAround(VesselBranch branch)
{
    std::ranges::reverse(branch.pointsInPatient);
    std::ranges::reverse(branch.radiusMm);
    return branch;
}

}   // namespace

Result<VesselTree> withBranch(const VesselTree& tree, VesselBranch branch)
{
    const auto inFront = trimInside(tree, branch);
    if (branch.pointsInPatient.size() < 2) {
        return Error(messages::branchRunsInside());
    }
    branch = turnedAround(std::move(branch));
    const auto atBack = trimInside(tree, branch);
    if (branch.pointsInPatient.size() < 2) {
        return Error(messages::branchRunsInside());
    }
    const auto generationOf = [](const std::optional<PlaceInBranch>& place) {
        return place && place->branch->generation >= 0 ? place->branch->generation : std::numeric_limits<int>::max();
    };
    const bool beginsAtBack = atBack && (!inFront || generationOf(atBack) < generationOf(inFront));
    const std::optional<PlaceInBranch>& parent = beginsAtBack ? atBack : inFront;
    if (!beginsAtBack) {
        branch = turnedAround(std::move(branch));
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
