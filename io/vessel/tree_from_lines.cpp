#include "io/messages/messages.h"
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
        return set.hasSurface ? messages::treeIsSurface() : messages::treeNoLines();
    }
    if (set.points.size() > maxCenterlinePoints) {
        return messages::treeTooManyPoints(set.points.size(), maxCenterlinePoints);
    }
    std::size_t total = 0;
    for (const auto& line : set.lines) {
        total += line.size();
        if (std::any_of(line.begin(), line.end(), [&](std::size_t i) { return i >= set.points.size(); })) {
            return messages::treeBadIndex();
        }
    }
    if (total > 4 * maxCenterlinePoints) {
        return messages::treePointsRepeated();
    }
    return {};
}

VesselBranch branchOf(const LineSet& set, std::size_t line)
{
    VesselBranch branch;
    branch.name = set.names.empty() ? std::string() : sanitizedBranchName(set.names[line]);
    for (const std::size_t index : set.lines[line]) {
        branch.pointsInPatient.push_back(set.points[index]);
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

double stepMm(const LineSet& set, const std::vector<std::size_t>& line, std::size_t next)
{
    return (set.points[line[next]] - set.points[line[next - 1]]).norm();
}

/// Steps of a line that are much longer than its median step; `at` holds the indices of the points after these steps.
struct Jumps {
    std::vector<std::size_t> at;
    double usualMm = 0.0;
    double longestMm = 0.0;
};

Jumps findJumps(const LineSet& set, const std::vector<std::size_t>& line)
{
    constexpr double minJumpMm = 5.0, leapSteps = 10.0;
    std::vector<double> steps;
    for (std::size_t i = 1; i < line.size(); ++i) {
        steps.push_back(stepMm(set, line, i));
        if (!std::isfinite(steps.back())) {   // non-finite points are reported later
            return {};
        }
    }
    Jumps leaps;
    if (steps.size() > 1) {
        const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
        std::nth_element(steps.begin(), middle, steps.end());
        leaps.usualMm = *middle;
    }
    for (std::size_t i = 1; i < line.size() && steps.size() > 1; ++i) {
        if (const double step = stepMm(set, line, i); step > std::max(minJumpMm, leapSteps * leaps.usualMm)) {
            leaps.at.push_back(i);
            leaps.longestMm = std::max(leaps.longestMm, step);
        }
    }
    return leaps;
}

/// Repairs leaps: if the start of a line is stored after its end, rotates the point order; otherwise cuts the line at
/// its leaps, which connect separate vessels. Two-point segments are not changed.
void repairJumps(LineSet& set)
{
    constexpr double joiningSteps = 3.0;
    LineSet mended;
    std::size_t turned = 0, cuts = 0;
    double longestMm = 0.0;
    for (std::size_t k = 0; k < set.lines.size(); ++k) {
        std::vector<std::size_t>& line = set.lines[k];
        Jumps leaps = findJumps(set, line);
        if (leaps.at.size() == 1 &&
            (set.points[line.back()] - set.points[line.front()]).norm() <= joiningSteps * leaps.usualMm) {
            std::ranges::rotate(line, line.begin() + static_cast<std::ptrdiff_t>(leaps.at.front()));
            leaps.at.clear();
            ++turned;
        }
        cuts += leaps.at.size();
        longestMm = leaps.at.empty() ? longestMm : std::max(longestMm, leaps.longestMm);
        leaps.at.push_back(line.size());
        std::size_t first = 0;
        for (const std::size_t end : leaps.at) {
            mended.lines.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(first),
                                      line.begin() + static_cast<std::ptrdiff_t>(end));
            if (!set.ids.empty()) {
                mended.ids.push_back(set.ids[k]);
            }
            if (!set.names.empty()) {
                mended.names.push_back(set.names[k]);
            }
            first = end;
        }
    }
    set.lines = std::move(mended.lines);
    set.ids = std::move(mended.ids);
    set.names = std::move(mended.names);
    if (turned > 0) {
        set.warnings.push_back(messages::treeTurnedRound(turned));
    }
    if (cuts > 0) {
        set.warnings.push_back(messages::treeLeaps(cuts, core::Quantity{longestMm, 1, "mm"}));
    }
}

/// Keeps the IDs of the file if they are unique; otherwise numbers the branches 1…n in file order.
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

std::string sanitizedBranchName(std::string_view text)
{
    std::string name(text);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
    return std::string(trimmed(name));
}

core::Result<LoadedTree> treeFromLines(LineSet set, const std::string& path)
{
    if (const auto damage = findDamage(set)) {
        return fileError(path, *damage);
    }
    repairJumps(set);
    set = chainSegments(set);
    core::VesselTree tree;
    for (std::size_t i = 0; i < set.lines.size(); ++i) {
        VesselBranch branch = branchOf(set, i);
        if (branch.pointsInPatient.size() > 1 && branch.lengthMm() != 0.0) {   // NaN is kept, to be reported
            branch.id = set.ids.empty() ? static_cast<int>(i) + 1 : set.ids[i];
            tree.branches.push_back(std::move(branch));
        }
    }
    if (tree.branches.empty()) {
        return fileError(path, messages::treeNoLength());
    }
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            if (!point.allFinite() || point.cwiseAbs().maxCoeff() > 1e6) {
                return fileError(path, messages::surfaceCoordinate());
            }
        }
    }
    if (tree.branches.size() > maxCenterlineBranches) {
        return fileError(path, messages::treeTooManyLines(tree.branches.size(), maxCenterlineBranches));
    }
    tree.branches = splitSharedTrunks(tree.branches);
    numberBranches(tree.branches, !set.ids.empty());
    if (const auto problem = core::findProblem(tree)) {
        return fileError(path, *problem);
    }
    return LoadedTree{std::move(tree), std::move(set.warnings)};
}

}   // namespace angiopose::io
