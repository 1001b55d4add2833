#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/vessel/line_set.h"
#include "io/vessel/shared_trunk.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace angiopose::io {
namespace {

using core::VesselBranch;

std::optional<core::Message> findDamage(const LineSet& set)
{
    if (set.lines.empty()) {
        return set.hasSurface ? says::treeIsSurface() : says::treeNoLines();
    }
    if (set.points.size() > maxCenterlinePoints) {
        return says::treeTooManyPoints(set.points.size(), maxCenterlinePoints);
    }
    std::size_t total = 0;
    for (const auto& line : set.lines) {
        total += line.size();
        if (std::any_of(line.begin(), line.end(), [&](std::size_t i) { return i >= set.points.size(); })) {
            return says::treeBadIndex();
        }
    }
    if (total > 4 * maxCenterlinePoints) {
        return says::treePointsRepeated();
    }
    return {};
}

VesselBranch branchOf(const LineSet& set, std::size_t line)
{
    VesselBranch branch;
    branch.name = set.names.empty() ? std::string() : branchName(set.names[line]);
    for (const std::size_t index : set.lines[line]) {
        Eigen::Vector3d point = set.points[index];
        if (set.isRas) {
            point.head<2>() = -point.head<2>();
        }
        branch.pointsInPatient.push_back(point);
        if (!set.radius.empty()) {
            branch.radiusMm.push_back(set.radius[index]);
        }
    }
    const bool known = std::all_of(branch.radiusMm.begin(), branch.radiusMm.end(),
                                   [](double radius) { return std::isfinite(radius) && radius >= 0.0; });
    if (!known) {
        branch.radiusMm.clear();
    }
    return branch;
}

/// The file's ids where each names one branch, otherwise 1…n in file order.
void numberBranches(std::vector<VesselBranch>& branches, bool hasIds)
{
    std::set<int> seen;
    const bool unique = hasIds && std::all_of(branches.begin(), branches.end(), [&](const VesselBranch& branch) {
                            return seen.insert(branch.id).second;
                        });
    for (std::size_t i = 0; i < branches.size() && !unique; ++i) {
        branches[i].id = static_cast<int>(i) + 1;
    }
}

}   // namespace

std::string branchName(std::string_view text)
{
    std::string name(text);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
    return std::string(trimmed(name));
}

core::Result<core::VesselTree> treeFromLines(LineSet set, const std::string& path)
{
    if (const auto damage = findDamage(set)) {
        return fileError(path, *damage);
    }
    set = chainSegments(set);
    core::VesselTree tree;
    for (std::size_t i = 0; i < set.lines.size(); ++i) {
        VesselBranch branch = branchOf(set, i);
        if (branch.pointsInPatient.size() > 1 && branch.lengthMm() != 0.0) {   // NaN stays, to be reported
            branch.id = set.ids.empty() ? static_cast<int>(i) + 1 : set.ids[i];
            tree.branches.push_back(std::move(branch));
        }
    }
    if (tree.branches.empty()) {
        return fileError(path, says::treeNoLength());
    }
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            if (!point.allFinite() || point.cwiseAbs().maxCoeff() > 1e6) {
                return fileError(path, says::surfaceCoordinate());
            }
        }
    }
    if (tree.branches.size() > maxCenterlineBranches) {
        return fileError(path, says::treeTooManyLines(tree.branches.size(), maxCenterlineBranches));
    }
    tree.branches = withoutSharedTrunks(tree.branches);
    numberBranches(tree.branches, !set.ids.empty());
    if (const auto problem = core::findProblem(tree)) {
        return fileError(path, *problem);
    }
    return tree;
}

}   // namespace angiopose::io