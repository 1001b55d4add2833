#include "core/vessel/polyline.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/vessel/line_set.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace angiopose::io {
namespace {

using core::VesselBranch;

constexpr double sharedDistanceMm = 0.1;
constexpr double minSharedLengthMm = 3.0;
constexpr std::size_t chunkSegments = 32;

/// Finds the nearest segment of a polyline within sharedDistanceMm; uses bounding boxes of groups of segments to speed
/// up the search.
class CurveIndex {
public:
    explicit CurveIndex(const std::vector<Eigen::Vector3d>& points) : points_(&points)
    {
        for (std::size_t first = 0; first + 1 < points.size(); first += chunkSegments) {
            Eigen::AlignedBox3d box;
            for (std::size_t i = first; i <= std::min(first + chunkSegments, points.size() - 1); ++i) {
                box.extend(points[i]);
            }
            boxes_.push_back(box);
        }
    }

    /// Returns the index of the segment nearest to `point`; nullopt if no segment is within sharedDistanceMm.
    std::optional<std::size_t> segmentNear(const Eigen::Vector3d& point) const
    {
        double best = sharedDistanceMm * sharedDistanceMm;
        std::optional<std::size_t> found;
        for (std::size_t chunk = 0; chunk < boxes_.size(); ++chunk) {
            if (boxes_[chunk].squaredExteriorDistance(point) > best) {
                continue;
            }
            const std::size_t first = chunk * chunkSegments;
            for (std::size_t i = first; i + 1 < points_->size() && i < first + chunkSegments; ++i) {
                const double squared = squaredDistance(point, (*points_)[i], (*points_)[i + 1]);
                if (squared <= best) {
                    best = squared;
                    found = i;
                }
            }
        }
        return found;
    }

private:
    static double squaredDistance(const Eigen::Vector3d& point, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    {
        const Eigen::Vector3d along = to - from;
        const double squaredLength = along.squaredNorm();
        const double t = squaredLength > 0.0 ? std::clamp((point - from).dot(along) / squaredLength, 0.0, 1.0) : 0.0;
        return (from + t * along - point).squaredNorm();
    }

    const std::vector<Eigen::Vector3d>* points_;
    std::vector<Eigen::AlignedBox3d> boxes_;
};

/// Point of an earlier line at which another line leaves or joins it, and at which it is cut.
struct Cut {
    std::size_t line;
    std::size_t point;
};

struct Run {
    std::size_t first;
    std::size_t last;
};

/// Position on an earlier line that coincides with a point of this line.
struct Contact {
    std::size_t line;
    std::size_t point;
};

std::vector<std::optional<Contact>> contactsOf(const VesselBranch& line, const std::vector<CurveIndex>& earlier)
{
    std::vector<std::optional<Contact>> contacts(line.pointsInPatient.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        for (std::size_t k = 0; k < earlier.size() && !contacts[i]; ++k) {
            if (const auto segment = earlier[k].segmentNear(line.pointsInPatient[i])) {
                contacts[i] = Contact{k, *segment};
            }
        }
    }
    return contacts;
}

double runLengthMm(const VesselBranch& line, const Run& run)
{
    double length = 0.0;
    for (std::size_t i = run.first + 1; i <= run.last; ++i) {
        length += (line.pointsInPatient[i] - line.pointsInPatient[i - 1]).norm();
    }
    return length;
}

/// Removes contacts shorter than minSharedLengthMm: lines that only touch or cross do not share a trunk.
void dropShortContacts(const VesselBranch& line, std::vector<std::optional<Contact>>& contacts)
{
    for (std::size_t first = 0; first < contacts.size();) {
        std::size_t end = first;
        while (end < contacts.size() && contacts[end].has_value() == contacts[first].has_value()) {
            ++end;
        }
        if (contacts[first] && runLengthMm(line, {first, end - 1}) < minSharedLengthMm) {
            std::fill(contacts.begin() + static_cast<std::ptrdiff_t>(first),
                      contacts.begin() + static_cast<std::ptrdiff_t>(end), std::nullopt);
        }
        first = end;
    }
}

/// Returns the sections of a line that no earlier line covers, each extended by one point at both ends.
std::vector<Run> ownRuns(const std::vector<std::optional<Contact>>& contacts, std::vector<Cut>& cuts)
{
    std::vector<Run> runs;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (contacts[i]) {
            continue;
        }
        Run run{i, i};
        while (run.last + 1 < contacts.size() && !contacts[run.last + 1]) {
            ++run.last;
        }
        i = run.last;
        if (run.first > 0) {
            --run.first;
            cuts.push_back({contacts[run.first]->line, contacts[run.first]->point});
        }
        if (run.last + 1 < contacts.size()) {
            ++run.last;
            cuts.push_back({contacts[run.last]->line, contacts[run.last]->point});
        }
        runs.push_back(run);
    }
    return runs;
}

VesselBranch piece(const VesselBranch& line, const Run& run)
{
    const auto from = static_cast<std::ptrdiff_t>(run.first);
    const auto to = static_cast<std::ptrdiff_t>(run.last) + 1;
    VesselBranch part{line.id, line.name, {line.pointsInPatient.begin() + from, line.pointsInPatient.begin() + to}, {}};
    if (!line.radiusMm.empty()) {
        part.radiusMm.assign(line.radiusMm.begin() + from, line.radiusMm.begin() + to);
    }
    return part;
}

/// Cuts a section at its bifurcations, unless a stub would remain, and appends the parts to `pieces`.
void appendPieces(const VesselBranch& line, Run run, std::vector<std::size_t> cuts, std::vector<VesselBranch>& pieces)
{
    std::sort(cuts.begin(), cuts.end());
    for (const std::size_t cut : cuts) {
        if (cut > run.first && cut < run.last && runLengthMm(line, {run.first, cut}) >= minSharedLengthMm &&
            runLengthMm(line, {cut, run.last}) >= minSharedLengthMm) {
            pieces.push_back(piece(line, {run.first, cut}));
            run.first = cut;
        }
    }
    pieces.push_back(piece(line, run));
}

/// Removes repeated trunks: VMTK writes one line per outlet, each starting at the inlet, so every line repeats the
/// trunk. Returns pieces that cover every vessel once, cut at the bifurcations; lines that share nothing are returned
/// unchanged, with their IDs. Two lines share a section if they stay closer than 0.1 mm for at least 3 mm.
std::vector<VesselBranch> splitSharedTrunks(const std::vector<VesselBranch>& lines)
{
    std::vector<CurveIndex> indices;
    std::vector<std::vector<Run>> runsOfLine;
    std::vector<Cut> cuts;
    for (const VesselBranch& line : lines) {
        auto contacts = contactsOf(line, indices);
        dropShortContacts(line, contacts);
        runsOfLine.push_back(ownRuns(contacts, cuts));
        indices.emplace_back(line.pointsInPatient);
    }
    if (cuts.empty() &&
        std::all_of(runsOfLine.begin(), runsOfLine.end(), [](const auto& runs) { return !runs.empty(); })) {
        return lines;
    }
    std::vector<VesselBranch> pieces;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        std::vector<std::size_t> own;
        for (const Cut& cut : cuts) {
            if (cut.line == k) {
                own.push_back(cut.point);
            }
        }
        for (const Run& run : runsOfLine[k]) {
            if (run.last > run.first) {
                appendPieces(lines[k], run, own, pieces);
            }
        }
    }
    return pieces;
}

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

/// Segments of a line that are much longer than its median segment; `at` holds the indices of the points after them.
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

/// Repairs jumps: if the start of a line is stored after its end, rotates the point order; otherwise cuts the line at
/// its jumps, which connect separate vessels. Two-point segments are not changed.
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
        if (branch.pointsInPatient.size() > 1 && branch.lengthMm() != 0.0) {   // keeps NaN, which is reported later
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
