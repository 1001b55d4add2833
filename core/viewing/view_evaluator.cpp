#include "core/viewing/view_evaluator.h"

#include "core/geometry/projection_camera.h"
#include "core/messages/messages.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double segmentLengthMm = 1.0;

void addSegments(const VesselBranch& branch, std::vector<VesselSegment>& pieces)
{
    for (std::size_t i = 1; i < branch.pointsInPatient.size(); ++i) {
        const Eigen::Vector3d& from = branch.pointsInPatient[i - 1];
        const Eigen::Vector3d& to = branch.pointsInPatient[i];
        const double radiusMm =
            branch.radiusMm.empty() ? assumedRadiusMm : 0.5 * (branch.radiusMm[i - 1] + branch.radiusMm[i]);
        pieces.push_back({0.5 * (from + to), to - from, radiusMm, branch.id});
    }
}

const VesselNode* takeoffNode(const VesselBranch& branch, const std::vector<VesselNode>& nodes)
{
    const VesselNode* nearest = nullptr;
    double minMm = std::numeric_limits<double>::infinity();
    for (const VesselNode& node : nodes) {
        const double distanceMm = (node.pointInPatient - branch.pointsInPatient.front()).norm();
        if (node.isBifurcation() && std::ranges::count(node.branchIds, branch.id) > 0 && distanceMm < minMm) {
            nearest = &node;
            minMm = distanceMm;
        }
    }
    return nearest;
}

}   // namespace

std::vector<VesselSegment> vesselSegmentsOf(const VesselTree& tree)
{
    std::vector<VesselSegment> pieces;
    for (const VesselBranch& branch : resampled(tree, segmentLengthMm).branches) {
        addSegments(branch, pieces);
    }
    return pieces;
}

std::vector<VesselSegment> branchSegments(const std::vector<VesselSegment>& pieces, int branchId)
{
    std::vector<VesselSegment> found;
    std::ranges::copy_if(pieces, std::back_inserter(found),
                         [branchId](const VesselSegment& piece) { return piece.branchId == branchId; });
    return found;
}

Result<std::vector<VesselSegment>> takeoffSegments(const VesselTree& tree, int branchId, double reachMm)
{
    const VesselBranch* branch = tree.find(branchId);
    if (!branch) {
        return Error(messages::noSuchBranch(branchId));
    }
    const std::vector<VesselNode> nodes = findNodes(resampled(tree, segmentLengthMm));
    const VesselNode* takeoff = takeoffNode(*branch, nodes);
    if (!takeoff) {
        return Error(messages::branchHasNoTakeoff(branchId));
    }
    std::vector<VesselSegment> found;
    for (const VesselSegment& piece : vesselSegmentsOf(tree)) {
        const bool meetsThere = std::ranges::count(takeoff->branchIds, piece.branchId) > 0;
        if (meetsThere && (piece.midpointInPatient - takeoff->pointInPatient).norm() <= reachMm) {
            found.push_back(piece);
        }
    }
    return found;
}

/// A vessel segment projected to the plane one millimeter from the source, where the detector distance has no effect.
struct ViewEvaluator::ProjectedSegment {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double radius = 0.0;   ///< negative if the segment is not in front of the source
    double sine = 0.0;   ///< sine of the angle between the vessel and the ray
};

namespace {

constexpr double contactGapMm = 1.0;
constexpr double contactRadii = 1.5;

bool isTouching(const VesselSegment& a, const VesselSegment& b)
{
    const double reach = contactRadii * (a.radiusMm + b.radiusMm) + contactGapMm;
    return (a.midpointInPatient - b.midpointInPatient).squaredNorm() < reach * reach;
}

/// Returns the fraction of a vessel's width (half-width `radius`) that is covered by another vessel of half-width
/// `other` at the lateral distance `apart`.
double overlapFraction(double radius, double other, double apart)
{
    const double low = std::max(-radius, apart - other);
    const double high = std::min(radius, apart + other);
    return std::clamp((high - low) / (2.0 * radius), 0.0, 1.0);
}

/// Sorts positions into square cells, for skipping segments that are too far away to overlap.
class PositionGrid {
public:
    PositionGrid(const std::vector<Eigen::Vector2d>& places, double minCellSize)
    {
        Eigen::Vector2d high = places.front();
        low_ = places.front();
        for (const Eigen::Vector2d& place : places) {
            low_ = low_.cwiseMin(place);
            high = high.cwiseMax(place);
        }
        cellSize_ = std::max(minCellSize, (high - low_).maxCoeff() / maxCellsAlong);
        columns_ = indexOf(high.x() - low_.x()) + 1;
        rows_ = indexOf(high.y() - low_.y()) + 1;
        cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Eigen::Vector2d offset = places[i] - low_;
            cells_[cellAt(indexOf(offset.x()), indexOf(offset.y()))].push_back(i);
        }
    }

    /// Calls `visit(i)` for every position within one cell size of `place`, and for some positions beyond.
    template <class Visit>
    void near(const Eigen::Vector2d& place, const Visit& visit) const
    {
        const Eigen::Vector2d offset = place - low_;
        if (offset.x() < -cellSize_ || offset.y() < -cellSize_ || offset.x() > (columns_ + 1) * cellSize_ ||
            offset.y() > (rows_ + 1) * cellSize_) {
            return;
        }
        const int column = indexOf(offset.x()), row = indexOf(offset.y());
        for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y) {
            for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
                std::ranges::for_each(cells_[cellAt(x, y)], visit);
            }
        }
    }

private:
    static constexpr double maxCellsAlong = 64.0;

    int indexOf(double offset) const { return static_cast<int>(std::floor(offset / cellSize_)); }
    std::size_t cellAt(int column, int row) const { return static_cast<std::size_t>(row * columns_ + column); }

    Eigen::Vector2d low_;
    double cellSize_ = 0.0;
    int columns_ = 0, rows_ = 0;
    std::vector<std::vector<std::size_t>> cells_;
};

}   // namespace

ViewEvaluator::ViewEvaluator(std::vector<VesselSegment> part, std::vector<VesselSegment> all)
    : part_(std::move(part)), all_(std::move(all))
{
    for (const VesselSegment& piece : part_) {
        partLengthMm_ += piece.alongMm.norm();
    }
}

ViewEvaluator::ProjectedSegment ViewEvaluator::projectSegment(const RigidTransform& cameraFromPatient,
                                                              const VesselSegment& piece) const
{
    const Eigen::Vector3d at = cameraFromPatient * piece.midpointInPatient;
    if (at.z() < minProjectableDepthMm) {
        return {Eigen::Vector2d::Zero(), -1.0, 0.0};
    }
    const Eigen::Vector3d along = cameraFromPatient.rotation * piece.alongMm;
    return {at.head<2>() / at.z(), piece.radiusMm / at.z(), along.cross(at).norm() / (along.norm() * at.norm())};
}

ViewQuality ViewEvaluator::from(const RigidTransform& cameraFromPatient) const
{
    std::vector<ProjectedSegment> seen;
    for (const VesselSegment& piece : part_) {
        seen.push_back(projectSegment(cameraFromPatient, piece));
    }
    const std::vector<double> covered = overlapFractions(cameraFromPatient, seen);
    ViewQuality quality;
    for (std::size_t i = 0; i < part_.size(); ++i) {
        const double share = part_[i].alongMm.norm() / partLengthMm_;
        quality.foreshortening += share * (1.0 - seen[i].sine);
        quality.overlap += share * covered[i];
    }
    return quality;
}

std::vector<double> ViewEvaluator::overlapFractions(const RigidTransform& cameraFromPatient,
                                                    const std::vector<ProjectedSegment>& part) const
{
    std::vector<Eigen::Vector2d> places;
    std::vector<double> covered;
    double widest = 0.0;
    for (const ProjectedSegment& seen : part) {
        places.push_back(seen.place);
        covered.push_back(seen.radius < 0.0 ? 1.0 : 0.0);
        widest = std::max(widest, seen.radius);
    }
    std::vector<ProjectedSegment> others;
    double widestOther = 0.0;
    for (const VesselSegment& piece : all_) {
        others.push_back(projectSegment(cameraFromPatient, piece));
        widestOther = std::max(widestOther, others.back().radius);
    }
    const PositionGrid cells(places, std::max(widest + widestOther, 1e-6));
    for (std::size_t k = 0; k < others.size(); ++k) {
        if (others[k].radius < 0.0) {
            continue;
        }
        cells.near(others[k].place, [&](std::size_t i) {
            const double apart = (part[i].place - others[k].place).norm();
            if (part[i].radius > 0.0 && apart < part[i].radius + others[k].radius && !isTouching(part_[i], all_[k])) {
                covered[i] = std::max(covered[i], overlapFraction(part[i].radius, others[k].radius, apart));
            }
        });
    }
    return covered;
}

Result<ViewEvaluator> makeViewEvaluator(const VesselTree& tree, int branchId, EvaluatedPart evaluatedPart)
{
    std::vector<VesselSegment> all = vesselSegmentsOf(tree);
    if (evaluatedPart == EvaluatedPart::Takeoff) {
        auto takeoff = takeoffSegments(tree, branchId);
        return takeoff ? Result(ViewEvaluator(std::move(takeoff).value(), std::move(all))) : takeoff.error();
    }
    std::vector<VesselSegment> branch = branchSegments(all, branchId);
    if (branch.empty()) {
        return Error(messages::noSuchBranch(branchId));
    }
    return ViewEvaluator(std::move(branch), std::move(all));
}

}   // namespace angiopose::core
