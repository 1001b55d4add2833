#include "io/vessel_tree_file.h"

#include "io/decode/vtk_file.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/vessel/markups.h"
#include "io/vessel/stated_coordinates.h"
#include "io/vessel/tree_table.h"
#include "io/vessel/vtk_lines.h"
#include "io/vessel/vtp_text.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <unordered_map>

namespace angiopose::io {
namespace {

/// Row of an SWC file: ID, type, x, y, z, radius, parent.
using SwcRow = std::array<double, 7>;

std::optional<SwcRow> parseRow(std::string_view line)
{
    SwcRow row{};
    for (double& value : row) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(" \t"));
        const auto number = parseNumber(word);
        if (!number) {
            return std::nullopt;
        }
        value = *number;
        line.remove_prefix(word.size());
    }
    return row;
}

constexpr double touchMm = 1.5;   // same distance as in the branch joining of core/vessel/vessel_tree.h
constexpr double longestGapMm = 10.0;   // maximum width of a bifurcation at whose rim centerlines start
constexpr int meetingType = 5;
constexpr std::string_view meetingNote = "type 5 where branches meet";   // other programs may use it differently

/// Attachment point of a branch end: the nearest row already written.
struct Attachment {
    int row = -1;
    double distanceMm = std::numeric_limits<double>::max();

    void consider(int candidate, double distance)
    {
        if (distance < distanceMm) {
            *this = {candidate, distance};
        }
    }
};

struct PendingBranch {
    core::VesselBranch branch;
    Attachment front;
    Attachment back;

    double distanceMm() const { return std::min(front.distanceMm, back.distanceMm); }

    void turnAround()
    {
        std::reverse(branch.pointsInPatient.begin(), branch.pointsInPatient.end());
        std::reverse(branch.radiusMm.begin(), branch.radiusMm.end());
        std::swap(front, back);
    }
};

/// Row to write, whose ID is its position, starting at 1.
struct WrittenRow {
    Eigen::Vector3d point;
    double radiusMm = 0.0;
    int parent = -1;
    bool isMeeting = false;   ///< whether branches meet at the point
};

std::string textOf(const std::vector<WrittenRow>& rows)
{
    std::string text = "# id type x y z radius parent; mm, patient LPS; " + std::string(meetingNote) + "\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const WrittenRow& row = rows[i];
        text += std::to_string(i + 1) + (row.isMeeting ? " 5 " : " 0 ") + toText(row.point.x()) + " " +
                toText(row.point.y()) + " " + toText(row.point.z()) + " " + toText(row.radiusMm) + " " +
                std::to_string(row.parent) + "\n";
    }
    return text;
}

/// Returns whether `place` continues the end of the curve with a deviation of at most 60°.
bool pointsTo(const std::vector<Eigen::Vector3d>& curve, const Eigen::Vector3d& place)
{
    constexpr double minAgreement = 0.5;
    const Eigen::Vector3d onward = place - curve.back();
    const Eigen::Vector3d direction = curve.back() - curve[curve.size() - std::min<std::size_t>(curve.size(), 4)];
    return onward.dot(direction) >= minAgreement * onward.norm() * direction.norm();
}

class SwcWriter {
public:
    explicit SwcWriter(const core::VesselTree& tree)
    {
        for (const core::VesselBranch& branch : tree.branches) {
            pending_.push_back({branch, {}, {}});
            pending_.back().branch.radiusMm.resize(branch.pointsInPatient.size(), 0.0);
        }
    }

    /// Writes all branches and returns the text. First come branches that share a point with written rows, then
    /// branches that touch written rows, then the next separate component.
    std::string run()
    {
        closeBifurcationGaps();
        while (!pending_.empty()) {
            auto next = std::ranges::min_element(pending_, {}, &PendingBranch::distanceMm);
            next = next->distanceMm() <= touchMm ? next : pending_.begin();
            PendingBranch branch = std::move(*next);
            pending_.erase(next);
            write(std::move(branch));
        }
        return textOf(rows_);
    }

private:
    /// Closes gaps at bifurcations: if several branches start at a point that no other branch reaches, extends a nearby
    /// branch end to that point.
    void closeBifurcationGaps()
    {
        for (std::size_t i = 0; i < pending_.size(); ++i) {
            const Eigen::Vector3d fork = pending_[i].branch.pointsInPatient.front();
            const auto begins = [&](const PendingBranch& each) {
                return (each.branch.pointsInPatient.front() - fork).norm() <= touchMm;
            };
            if (std::ranges::count_if(pending_, begins) < 2 || isReached(fork, begins)) {
                continue;
            }
            PendingBranch* leading = nullptr;
            double nearestMm = longestGapMm;
            for (PendingBranch& each : pending_) {
                const Eigen::Vector3d& end = each.branch.pointsInPatient.back();
                const double away = (end - fork).norm();
                if (away <= nearestMm && !begins(each) && pointsTo(each.branch.pointsInPatient, fork) &&
                    !isReached(end, [&each](const PendingBranch& other) { return &other == &each; })) {
                    nearestMm = away;
                    leading = &each;
                }
            }
            if (leading != nullptr) {
                leading->branch.pointsInPatient.push_back(fork);
                leading->branch.radiusMm.push_back(pending_[i].branch.radiusMm.front());
            }
        }
    }

    /// Returns whether a branch for which `isOwn` is false passes near `place`.
    template <class IsOwn>
    bool isReached(const Eigen::Vector3d& place, const IsOwn& isOwn) const
    {
        return std::ranges::any_of(pending_, [&](const PendingBranch& each) {
            return !isOwn(each) && std::ranges::any_of(each.branch.pointsInPatient, [&](const Eigen::Vector3d& point) {
                return (point - place).norm() <= touchMm;
            });
        });
    }

    void write(PendingBranch branch)
    {
        if (branch.back.distanceMm < branch.front.distanceMm && branch.back.distanceMm <= touchMm) {
            branch.turnAround();
        }
        const bool isSamePoint = branch.front.distanceMm == 0.0;
        int parent = branch.front.distanceMm <= touchMm ? branch.front.row : -1;
        if (parent > 0) {
            rows_[static_cast<std::size_t>(parent) - 1].isMeeting = true;
        }
        for (std::size_t i = isSamePoint ? 1 : 0; i < branch.branch.pointsInPatient.size(); ++i) {
            parent = addRow(branch.branch.pointsInPatient[i], branch.branch.radiusMm[i], parent);
        }
    }

    int addRow(const Eigen::Vector3d& point, double radiusMm, int parent)
    {
        rows_.push_back({point, radiusMm, parent});
        const int row = static_cast<int>(rows_.size());
        for (PendingBranch& branch : pending_) {
            branch.front.consider(row, (branch.branch.pointsInPatient.front() - point).norm());
            branch.back.consider(row, (branch.branch.pointsInPatient.back() - point).norm());
        }
        return row;
    }

    std::vector<PendingBranch> pending_;
    std::vector<WrittenRow> rows_;
};

/// Parses SWC rows `id type x y z radius parent` as segments between points.
core::Result<LineSet> parseSwc(std::string_view text, const std::string& path)
{
    LineSet set;
    const bool saysMeetings = text.substr(0, text.find('\n')).find(meetingNote) != std::string_view::npos;
    std::unordered_map<long, std::size_t> indexOfId;
    std::vector<std::pair<long, int>> parents;   // for each point, its parent and its line number in the file
    for (LineReader lines(text); lines.next();) {
        const auto row = parseRow(lines.line());
        if (!row || !(std::abs((*row)[0]) < 1e9) || !(std::abs((*row)[6]) < 1e9)) {
            return fileError(path, messages::swcLine(lines.number()));
        }
        if (!indexOfId.emplace(static_cast<long>((*row)[0]), set.points.size()).second) {
            return fileError(path, messages::swcIdTwice(lines.number()));
        }
        if (saysMeetings && (*row)[1] == meetingType) {
            set.junctions.insert(set.points.size());
        }
        set.points.emplace_back((*row)[2], (*row)[3], (*row)[4]);
        set.radius.push_back((*row)[5]);
        parents.emplace_back(static_cast<long>((*row)[6]), lines.number());
    }
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i].first < 0) {
            continue;
        }
        const auto parent = indexOfId.find(parents[i].first);
        if (parent == indexOfId.end()) {
            return fileError(path, messages::swcParentMissing(parents[i].second, parents[i].first));
        }
        set.lines.push_back({parent->second, i});
    }
    return set;
}

/// Returns a tree as SWC rows, in mm, with type 5 where branches meet and otherwise 0 (undefined). SWC stores only
/// parents: a branch whose first or last point lies within 1.5 mm of an existing row is attached to that row; if
/// branches start at a point that no other branch reaches, the nearest free branch end within 10 mm is extended to that
/// point. Other branches become roots. IDs and names are lost. Unknown radii are 0.
std::string swcText(const core::VesselTree& tree)
{
    return SwcWriter(tree).run();
}

/// Parses lines according to the content or, for plain tables, according to the extension; adds the descriptive text of
/// the file to `header`.
core::Result<LineSet> parseLines(std::string_view content, const std::string& path, std::string& header,
                                 const ReadObserver& observe)
{
    const bool isLegacyVtk = content.starts_with("# vtk DataFile");
    if (isLegacyVtk || content.substr(0, 4096).find("<VTKFile") != std::string_view::npos) {
        auto lines = isLegacyVtk ? readLegacyVtk(content, path, observe) : readXmlVtk(content, path, observe);
        if (!lines) {
            return lines.error();
        }
        header += lines.value().header;
        return lineSetOf(std::move(lines).value());
    }
    const std::string extension = extensionOf(path);
    const auto* found = describeContent(content);
    if (found == &messages::aJsonFile && extension == ".json") {
        return parseMarkups(content, path);
    }
    if (found != nullptr) {
        return fileError(path, messages::treeIsOther((*found)()));
    }
    if (extension == ".swc") {
        return parseSwc(content, path);
    }
    if (extension == ".csv" || extension == ".txt") {
        return parseTreeTable(content, path);
    }
    if (extension == ".vtk" || extension == ".vtp" || extension == ".vtu") {
        return fileError(path, messages::treeNoVtkBeginning());
    }
    return fileError(path, messages::treeFormatUnknown());
}

}   // namespace

core::Result<LoadedTree> readTree(const std::string& path, const VesselTreeReadOptions& options,
                                  const ReadObserver& observe)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    std::string header = headerText(input.value().view());
    auto lines = parseLines(input.value().view(), path, header, observe);
    // Slicer curves state their unit and are already converted to mm.
    const auto rule = coordinateConversion(header, extensionOf(path) == ".json" ? 1.0 : options.unitMm, path);
    if (!lines || !rule) {
        return lines ? rule.error() : lines.error();
    }
    LineSet set = std::move(lines).value();
    std::ranges::transform(set.points, set.points.begin(), rule.value());
    for (double& radius : set.radius) {
        radius *= rule.value().unitMm;
    }
    set.warnings.insert(set.warnings.begin(), rule.value().notes.begin(), rule.value().notes.end());
    auto tree = treeFromLines(std::move(set), path);
    if (!tree) {
        return tree;
    }
    LoadedTree read = std::move(tree).value();
    read.isUnitStated = rule.value().isUnitStated;
    return read;
}

core::Result<core::VesselTree> readVesselTree(const std::string& path, const VesselTreeReadOptions& options,
                                              const ReadObserver& observe)
{
    auto read = readTree(path, options, observe);
    return read ? core::Result<core::VesselTree>(std::move(read).value().tree) : read.error();
}

core::Status writeVesselTree(const core::VesselTree& tree, const std::string& path)
{
    const std::string extension = extensionOf(path);
    if (extension == ".csv") {
        return writeAtomically(path, treeTable(tree));
    }
    if (extension == ".vtp") {
        return writeAtomically(path, vtpText(tree));
    }
    if (extension == ".swc") {
        return writeAtomically(path, swcText(tree));
    }
    if (path.ends_with(".mrk.json")) {
        return writeAtomically(path, markupsText(tree));
    }
    return fileError(path, messages::treeExtension());
}

}   // namespace angiopose::io
