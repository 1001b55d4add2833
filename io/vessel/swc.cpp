#include "io/vessel/swc.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/text_lines.h"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

namespace angiopose::io {
namespace {

/// id, type, x, y, z, radius, parent.
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

constexpr double touchMm = 1.5;   // as nodes join branches (core/vessel/vessel_tree.h)

/// Where a branch end can hang: the nearest row that is written.
struct Hook {
    int row = -1;
    double distanceMm = std::numeric_limits<double>::max();

    void consider(int candidate, double distance)
    {
        if (distance < distanceMm) {
            *this = {candidate, distance};
        }
    }
};

/// A branch to be written.
struct PendingBranch {
    core::VesselBranch branch;
    Hook front;
    Hook back;

    double distanceMm() const { return std::min(front.distanceMm, back.distanceMm); }

    void turnAround()
    {
        std::reverse(branch.pointsInPatient.begin(), branch.pointsInPatient.end());
        std::reverse(branch.radiusMm.begin(), branch.radiusMm.end());
        std::swap(front, back);
    }
};

class SwcWriter {
public:
    explicit SwcWriter(const core::VesselTree& tree)
    {
        for (const core::VesselBranch& branch : tree.branches) {
            pending_.push_back({branch, {}, {}});
            pending_.back().branch.radiusMm.resize(branch.pointsInPatient.size(), 0.0);
        }
    }

    /// Branches that touch what is written come first, in the order of the tree.
    std::string run()
    {
        while (!pending_.empty()) {
            auto next = std::find_if(pending_.begin(), pending_.end(),
                                     [](const PendingBranch& branch) { return branch.distanceMm() <= touchMm; });
            next = next == pending_.end() ? pending_.begin() : next;
            PendingBranch branch = std::move(*next);
            pending_.erase(next);
            write(std::move(branch));
        }
        return std::move(text_);
    }

private:
    void write(PendingBranch branch)
    {
        if (branch.back.distanceMm < branch.front.distanceMm && branch.back.distanceMm <= touchMm) {
            branch.turnAround();
        }
        const bool isSamePoint = branch.front.distanceMm == 0.0;
        int parent = branch.front.distanceMm <= touchMm ? branch.front.row : -1;
        for (std::size_t i = isSamePoint ? 1 : 0; i < branch.branch.pointsInPatient.size(); ++i) {
            parent = addRow(branch.branch.pointsInPatient[i], branch.branch.radiusMm[i], parent);
        }
    }

    int addRow(const Eigen::Vector3d& point, double radiusMm, int parent)
    {
        ++rows_;
        text_ += std::to_string(rows_) + " 0 " + toText(point.x()) + " " + toText(point.y()) + " " + toText(point.z()) +
                 " " + toText(radiusMm) + " " + std::to_string(parent) + "\n";
        for (PendingBranch& branch : pending_) {
            branch.front.consider(rows_, (branch.branch.pointsInPatient.front() - point).norm());
            branch.back.consider(rows_, (branch.branch.pointsInPatient.back() - point).norm());
        }
        return rows_;
    }

    std::vector<PendingBranch> pending_;
    std::string text_ = "# id type x y z radius parent; mm, patient LPS\n";
    int rows_ = 0;
};

}   // namespace

core::Result<LineSet> parseSwc(std::string_view text, double unitMm, const std::string& path)
{
    LineSet set;
    std::unordered_map<long, std::size_t> indexOfId;
    std::vector<std::pair<long, int>> parents;   // of each point, with its line in the file
    for (TextLines lines(text); lines.next();) {
        const auto row = parseRow(lines.line());
        if (!row || !(std::abs((*row)[0]) < 1e9) || !(std::abs((*row)[6]) < 1e9)) {
            return fileError(path, says::swcLine(lines.number()));
        }
        if (!indexOfId.emplace(static_cast<long>((*row)[0]), set.points.size()).second) {
            return fileError(path, says::swcIdTwice(lines.number()));
        }
        set.points.emplace_back(unitMm * (*row)[2], unitMm * (*row)[3], unitMm * (*row)[4]);
        set.radius.push_back(unitMm * (*row)[5]);
        parents.emplace_back(static_cast<long>((*row)[6]), lines.number());
    }
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i].first < 0) {
            continue;
        }
        const auto parent = indexOfId.find(parents[i].first);
        if (parent == indexOfId.end()) {
            return fileError(path, says::swcParentMissing(parents[i].second, parents[i].first));
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