#include "io/vessel/shared_trunk.h"

#include "core/vessel/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

namespace angiopose::io {
namespace {

constexpr double sharedDistanceMm = 0.1;
constexpr double minSharedLengthMm = 3.0;
constexpr std::size_t chunkSegments = 32;

using core::VesselBranch;

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

/// Removes contacts over less than minSharedLengthMm: lines that only touch or cross do not share a trunk.
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

}   // namespace

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

}   // namespace angiopose::io
