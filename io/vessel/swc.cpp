#include "io/vessel/swc.h"

#include "io/messages/messages.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <array>
#include <limits>
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
constexpr double longestGapMm = 10.0;   // maximum width of a bifurcation whose centerlines start at its rim
constexpr int meetingType = 5;
constexpr std::string_view meetingNote = "type 5 where branches meet";   // other programs may use type 5 differently

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

/// Row to write; its ID is its position, starting at 1.
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

/// Whether `place` continues the end of the curve, with a deviation of at most 60°.
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
    /// Closes gaps at bifurcations: if several branches start at one point that no other branch reaches, extends a
    /// nearby branch end to this point.
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

    /// Whether a branch for which `isOwn` is false passes near `place`.
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

}   // namespace

core::Result<LineSet> parseSwc(std::string_view text, const std::string& path)
{
    LineSet set;
    const bool saysMeetings = text.substr(0, text.find('\n')).find(meetingNote) != std::string_view::npos;
    std::unordered_map<long, std::size_t> indexOfId;
    std::vector<std::pair<long, int>> parents;   // for each point, its parent and its line number in the file
    for (TextLines lines(text); lines.next();) {
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

std::string swcText(const core::VesselTree& tree)
{
    return SwcWriter(tree).run();
}

}   // namespace angiopose::io
