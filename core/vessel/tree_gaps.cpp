#include "core/vessel/tree_gaps.h"

#include "core/vessel/edit_tree.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace angiopose::core {
namespace {

constexpr std::size_t directionPoints = 5;   ///< number of points from which the direction of an end is computed

/// Returns the distance from a point to the polyline of a branch, including between its points, which may be far apart.
double distanceTo(const VesselBranch& branch, const Eigen::Vector3d& point)
{
    const auto& points = branch.pointsInPatient;
    double nearest = (points.front() - point).norm();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Eigen::Vector3d span = points[i] - points[i - 1];
        const double length = span.squaredNorm();
        const double fraction = length > 0.0 ? std::clamp((point - points[i - 1]).dot(span) / length, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, (points[i - 1] + fraction * span - point).norm());
    }
    return nearest;
}

/// Returns, for each branch, the representative of its connected component.
std::vector<std::size_t> componentsByBranch(const VesselTree& tree)
{
    const std::size_t count = tree.branches.size();
    std::vector<std::size_t> component(count);
    std::iota(component.begin(), component.end(), 0);
    const auto touches = [](const VesselBranch& branch, const VesselBranch& other) {
        return distanceTo(other, branch.pointsInPatient.front()) <= maxContactMm ||
               distanceTo(other, branch.pointsInPatient.back()) <= maxContactMm;
    };
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = 0; b < count; ++b) {
            if (component[a] != component[b] && touches(tree.branches[a], tree.branches[b])) {
                std::replace(component.begin(), component.end(), std::size_t{component[b]}, std::size_t{component[a]});
            }
        }
    }
    return component;
}

/// Returns the outward unit direction at an end of a branch.
Eigen::Vector3d outwardDirection(const VesselBranch& branch, bool isLastPoint)
{
    const auto& points = branch.pointsInPatient;
    const std::size_t reach = std::min(directionPoints, points.size() - 1);
    const Eigen::Vector3d span =
        isLastPoint ? points.back() - points[points.size() - 1 - reach] : points.front() - points[reach];
    return span.norm() > 1e-9 ? span.normalized().eval() : Eigen::Vector3d::Zero().eval();
}

/// Returns the plausibility of a gap, in which a short distance outweighs a change of direction.
double plausibilityOf(const TreeGap& gap)
{
    return (1.5 + gap.directionAgreement) / (maxContactMm + gap.distanceMm);
}

/// Returns the best connection from one end to a branch of another component.
TreeGap gapBetween(const VesselBranch& from, bool isLastPoint, const VesselBranch& to)
{
    TreeGap gap;
    gap.fromBranchId = from.id;
    gap.toBranchId = to.id;
    gap.fromInPatient = isLastPoint ? from.pointsInPatient.back() : from.pointsInPatient.front();
    const auto nearest =
        std::min_element(to.pointsInPatient.begin(), to.pointsInPatient.end(), [&](const auto& a, const auto& b) {
            return (a - gap.fromInPatient).squaredNorm() < (b - gap.fromInPatient).squaredNorm();
        });
    gap.toInPatient = *nearest;
    const bool isFront = nearest == to.pointsInPatient.begin();
    gap.toIsEnd = isFront || nearest + 1 == to.pointsInPatient.end();
    const Eigen::Vector3d span = gap.toInPatient - gap.fromInPatient;
    gap.distanceMm = span.norm();
    const Eigen::Vector3d direction =
        gap.distanceMm > 1e-9 ? (span / gap.distanceMm).eval() : outwardDirection(from, isLastPoint);
    gap.directionAgreement = outwardDirection(from, isLastPoint).dot(direction);
    if (gap.toIsEnd) {
        gap.directionAgreement = 0.5 * (gap.directionAgreement - outwardDirection(to, !isFront).dot(direction));
    }
    return gap;
}

double componentLength(const VesselTree& tree, const std::vector<std::size_t>& component, std::size_t which)
{
    double length = 0.0;
    for (std::size_t b = 0; b < component.size(); ++b) {
        length += component[b] == which ? tree.branches[b].lengthMm() : 0.0;
    }
    return length;
}

}   // namespace

std::vector<TreeGap> findGaps(const VesselTree& tree, double maxGapMm)
{
    const std::vector<std::size_t> component = componentsByBranch(tree);
    std::map<std::size_t, std::optional<TreeGap>> best;   // best gap of each component
    for (const std::size_t which : component) {
        best.try_emplace(which);
    }
    for (std::size_t a = 0; a < component.size(); ++a) {
        for (std::size_t b = 0; b < component.size(); ++b) {
            for (const bool isLastPoint : {false, true}) {
                if (component[a] == component[b]) {
                    continue;
                }
                const TreeGap gap = gapBetween(tree.branches[a], isLastPoint, tree.branches[b]);
                for (const std::size_t which : {component[a], component[b]}) {   // each gap counts for both components
                    std::optional<TreeGap>& known = best[which];
                    if (gap.distanceMm <= maxGapMm && (!known || plausibilityOf(gap) > plausibilityOf(*known))) {
                        known = gap;
                    }
                }
            }
        }
    }
    if (!best.empty()) {   // the largest component needs no gap; the others connect to it
        best.erase(std::max_element(best.begin(), best.end(), [&](const auto& a, const auto& b) {
            return componentLength(tree, component, a.first) < componentLength(tree, component, b.first);
        }));
    }
    std::vector<TreeGap> gaps;
    for (const auto& [which, gap] : best) {
        if (gap) {
            gaps.push_back(*gap);
        }
    }
    std::stable_sort(gaps.begin(), gaps.end(),
                     [](const TreeGap& a, const TreeGap& b) { return plausibilityOf(a) > plausibilityOf(b); });
    return gaps;
}

int componentCount(const VesselTree& tree)
{
    const std::vector<std::size_t> component = componentsByBranch(tree);
    return static_cast<int>(std::set<std::size_t>(component.begin(), component.end()).size());
}

Result<VesselTree> closeGap(const VesselTree& tree, const TreeGap& gap)
{
    const auto endAt = [&tree](int branchId, const Eigen::Vector3d& point) {
        const VesselBranch* branch = tree.find(branchId);
        const bool isFront = branch != nullptr && (branch->pointsInPatient.front() - point).norm() <
                                                      (branch->pointsInPatient.back() - point).norm();
        return BranchEnd{branchId, !isFront};
    };
    const BranchEnd from = endAt(gap.fromBranchId, gap.fromInPatient);
    return gap.toIsEnd ? joinAtEnds(tree, from, endAt(gap.toBranchId, gap.toInPatient))
                       : extendBranchTo(tree, from, gap.toInPatient);
}

}   // namespace angiopose::core
