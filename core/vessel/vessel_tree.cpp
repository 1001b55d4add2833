#include "core/vessel/vessel_tree.h"

#include "core/messages/messages.h"
#include "core/vessel/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace angiopose::core {
namespace {

struct BranchTip {
    int branchId;
    Eigen::Vector3d point;
};

std::vector<BranchTip> endsOf(const VesselTree& tree)
{
    std::vector<BranchTip> ends;
    for (const VesselBranch& branch : tree.branches) {
        if (!branch.pointsInPatient.empty()) {
            ends.push_back({branch.id, branch.pointsInPatient.front()});
            ends.push_back({branch.id, branch.pointsInPatient.back()});
        }
    }
    return ends;
}

/// A branch with its bounding box, used to rule out most points quickly.
struct BoxedBranch {
    const VesselBranch* branch;
    Eigen::AlignedBox3d box;

    bool passesNear(const Eigen::Vector3d& point, double toleranceMm) const
    {
        const double squared = toleranceMm * toleranceMm;
        const auto& points = branch->pointsInPatient;
        return box.squaredExteriorDistance(point) <= squared &&
               std::any_of(points.begin(), points.end(),
                           [&](const Eigen::Vector3d& p) { return (p - point).squaredNorm() <= squared; });
    }
};

std::vector<BoxedBranch> addBoxes(const VesselTree& tree)
{
    std::vector<BoxedBranch> all;
    for (const VesselBranch& branch : tree.branches) {
        all.push_back({&branch, {}});
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            all.back().box.extend(point);
        }
    }
    return all;
}

}   // namespace

double VesselBranch::lengthMm() const
{
    return polylineLength(pointsInPatient);
}

std::size_t VesselTree::pointCount() const
{
    std::size_t count = 0;
    for (const VesselBranch& branch : branches) {
        count += branch.pointsInPatient.size();
    }
    return count;
}

const VesselBranch* VesselTree::find(int branchId) const
{
    const auto found = std::find_if(branches.begin(), branches.end(),
                                    [&](const VesselBranch& branch) { return branch.id == branchId; });
    return found == branches.end() ? nullptr : &*found;
}

std::vector<VesselNode> findNodes(const VesselTree& tree, double toleranceMm)
{
    std::vector<VesselNode> nodes;
    const std::vector<BoxedBranch> branches = addBoxes(tree);
    for (const BranchTip& end : endsOf(tree)) {
        const bool known = std::any_of(nodes.begin(), nodes.end(), [&](const VesselNode& node) {
            return (node.pointInPatient - end.point).norm() <= toleranceMm;
        });
        if (known) {
            continue;
        }
        VesselNode node{end.point, {}};
        for (const BoxedBranch& boxedBranch : branches) {
            if (boxedBranch.passesNear(end.point, toleranceMm)) {
                node.branchIds.push_back(boxedBranch.branch->id);
            }
        }
        nodes.push_back(std::move(node));
    }
    return nodes;
}

Eigen::Vector3d centroidInPatient(const VesselTree& tree)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double length = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        const auto& points = branch.pointsInPatient;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double step = (points[i] - points[i - 1]).norm();
            sum += 0.5 * step * (points[i] + points[i - 1]);
            length += step;
        }
    }
    if (length > 0.0) {
        return sum / length;
    }
    return tree.pointCount() > 0 ? tree.branches.front().pointsInPatient.front() : Eigen::Vector3d::Zero().eval();
}

std::vector<Eigen::Vector3d> tangentsOf(const std::vector<Eigen::Vector3d>& points)
{
    return polylineTangents(points, 1);
}

VesselTree resampled(const VesselTree& tree, double spacingMm)
{
    VesselTree result;
    for (const VesselBranch& branch : tree.branches) {
        const std::vector<PolylineStation> stations = evenStations(branch.pointsInPatient, spacingMm);
        VesselBranch even{branch.id, branch.name, interpolate(branch.pointsInPatient, stations), {}, branch.generation};
        if (branch.radiusMm.size() == branch.pointsInPatient.size()) {
            even.radiusMm = interpolate(branch.radiusMm, stations);
        }
        result.branches.push_back(std::move(even));
    }
    return result;
}

VesselTree withoutBranches(const VesselTree& tree, const std::vector<int>& excludedIds)
{
    const std::set<int> excluded(excludedIds.begin(), excludedIds.end());
    VesselTree result;
    std::copy_if(tree.branches.begin(), tree.branches.end(), std::back_inserter(result.branches),
                 [&](const VesselBranch& branch) { return !excluded.contains(branch.id); });
    return result;
}

bool isCompact(const VesselTree& tree)
{
    double lengthMm = 0.0, maxRadiusMm = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        lengthMm += branch.lengthMm();
        for (const double radius : branch.radiusMm) {
            maxRadiusMm = std::max(maxRadiusMm, radius);
        }
    }
    return lengthMm < 2.0 * (2.0 * maxRadiusMm);
}

double extentMm(const VesselTree& tree)
{
    Eigen::AlignedBox3d box;
    for (const BoxedBranch& branch : addBoxes(tree)) {
        box.extend(branch.box);
    }
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

bool isPlausibleSize(const VesselTree& tree)
{
    constexpr double shortestMm = 10.0, longestMm = 2000.0;   // from one short branch to the vessels of a whole body
    constexpr double thinnestMm = 0.15, widestMm = 60.0;   // from half a CT voxel to an aneurysm
    const double across = extentMm(tree);
    if (across < shortestMm || across > longestMm) {
        return false;
    }
    std::vector<double> radiiMm;
    for (const VesselBranch& branch : tree.branches) {
        std::copy_if(branch.radiusMm.begin(), branch.radiusMm.end(), std::back_inserter(radiiMm),
                     [](double radius) { return radius > 0.0; });
    }
    if (radiiMm.empty()) {
        return true;
    }
    const auto middle = radiiMm.begin() + static_cast<std::ptrdiff_t>(radiiMm.size() / 2);
    std::nth_element(radiiMm.begin(), middle, radiiMm.end());
    return *middle >= thinnestMm && *middle <= widestMm;
}

std::optional<Message> findProblem(const VesselTree& tree)
{
    if (tree.branches.empty()) {
        return messages::treeWithoutBranches();
    }
    std::set<int> ids;
    for (const VesselBranch& branch : tree.branches) {
        if (!ids.insert(branch.id).second) {
            return messages::duplicateBranchId(branch.id);
        }
        if (branch.pointsInPatient.size() < 2) {
            return messages::branchTooFewPoints(branch.id);
        }
        const bool finite = std::all_of(branch.pointsInPatient.begin(), branch.pointsInPatient.end(),
                                        [](const Eigen::Vector3d& p) { return p.allFinite(); });
        if (!finite) {
            return messages::branchNotFinite(branch.id);
        }
        if (branch.lengthMm() <= 0.0) {
            return messages::branchWithoutLength(branch.id);
        }
        if (!branch.radiusMm.empty() && branch.radiusMm.size() != branch.pointsInPatient.size()) {
            return messages::branchRadiiMissing(branch.id);
        }
        if (!std::ranges::all_of(branch.radiusMm, [](double r) { return std::isfinite(r) && r >= 0.0; })) {
            return messages::branchRadiusUnusable(branch.id);
        }
    }
    return {};
}

}   // namespace angiopose::core
