#include "core/viewing/part_sight.h"

#include "core/geometry/projection_camera.h"
#include "core/messages/messages.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double pieceLengthMm = 1.0;

void addPieces(const VesselBranch& branch, std::vector<VesselPiece>& pieces)
{
    for (std::size_t i = 1; i < branch.pointsInPatient.size(); ++i) {
        const Eigen::Vector3d& from = branch.pointsInPatient[i - 1];
        const Eigen::Vector3d& to = branch.pointsInPatient[i];
        const double radiusMm =
            branch.radiusMm.empty() ? assumedRadiusMm : 0.5 * (branch.radiusMm[i - 1] + branch.radiusMm[i]);
        pieces.push_back({0.5 * (from + to), to - from, radiusMm, branch.id});
    }
}

const VesselNode* takeOffOf(const VesselBranch& branch, const std::vector<VesselNode>& nodes)
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

std::vector<VesselPiece> vesselPiecesOf(const VesselTree& tree)
{
    std::vector<VesselPiece> pieces;
    for (const VesselBranch& branch : resampled(tree, pieceLengthMm).branches) {
        addPieces(branch, pieces);
    }
    return pieces;
}

std::vector<VesselPiece> piecesOfBranch(const std::vector<VesselPiece>& pieces, int branchId)
{
    std::vector<VesselPiece> found;
    std::ranges::copy_if(pieces, std::back_inserter(found),
                         [branchId](const VesselPiece& piece) { return piece.branchId == branchId; });
    return found;
}

Result<std::vector<VesselPiece>> piecesOfTakeOff(const VesselTree& tree, int branchId, double reachMm)
{
    const VesselBranch* branch = tree.find(branchId);
    if (!branch) {
        return Error(messages::noSuchBranch(branchId));
    }
    const std::vector<VesselNode> nodes = findNodes(resampled(tree, pieceLengthMm));
    const VesselNode* takeOff = takeOffOf(*branch, nodes);
    if (!takeOff) {
        return Error(messages::noTakeOff(branchId));
    }
    std::vector<VesselPiece> found;
    for (const VesselPiece& piece : vesselPiecesOf(tree)) {
        const bool meetsThere = std::ranges::count(takeOff->branchIds, piece.branchId) > 0;
        if (meetsThere && (piece.middleInPatient - takeOff->pointInPatient).norm() <= reachMm) {
            found.push_back(piece);
        }
    }
    return found;
}

/// A vessel segment projected to the plane one millimeter from the source, where lengths are independent of the
/// detector distance.
struct PartSight::Seen {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double radius = 0.0;   ///< negative if the segment is not in front of the source
    double sine = 0.0;   ///< sine of the angle between the vessel and the ray
};

namespace {

constexpr double touchingGapMm = 1.0;
constexpr double touchingRadii = 1.5;

bool isTouching(const VesselPiece& a, const VesselPiece& b)
{
    const double reach = touchingRadii * (a.radiusMm + b.radiusMm) + touchingGapMm;
    return (a.middleInPatient - b.middleInPatient).squaredNorm() < reach * reach;
}

/// Returns the fraction of a vessel's width (half-width `radius`) that is covered by another vessel of half-width
/// `other` at the lateral distance `apart`.
double coveredWidth(double radius, double other, double apart)
{
    const double low = std::max(-radius, apart - other);
    const double high = std::min(radius, apart + other);
    return std::clamp((high - low) / (2.0 * radius), 0.0, 1.0);
}

/// Sorts positions into square cells, for skipping segments that are too far away to overlap.
class PlaceCells {
public:
    PlaceCells(const std::vector<Eigen::Vector2d>& places, double minCellSize)
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

PartSight::PartSight(std::vector<VesselPiece> part, std::vector<VesselPiece> all)
    : part_(std::move(part)), all_(std::move(all))
{
    for (const VesselPiece& piece : part_) {
        partLengthMm_ += piece.alongMm.norm();
    }
}

PartSight::Seen PartSight::seenFrom(const RigidTransform& cameraFromPatient, const VesselPiece& piece) const
{
    const Eigen::Vector3d at = cameraFromPatient * piece.middleInPatient;
    if (at.z() < minProjectableDepthMm) {
        return {Eigen::Vector2d::Zero(), -1.0, 0.0};
    }
    const Eigen::Vector3d along = cameraFromPatient.rotation * piece.alongMm;
    return {at.head<2>() / at.z(), piece.radiusMm / at.z(), along.cross(at).norm() / (along.norm() * at.norm())};
}

SightQuality PartSight::from(const RigidTransform& cameraFromPatient) const
{
    std::vector<Seen> seen;
    for (const VesselPiece& piece : part_) {
        seen.push_back(seenFrom(cameraFromPatient, piece));
    }
    const std::vector<double> covered = coveredShares(cameraFromPatient, seen);
    SightQuality quality;
    for (std::size_t i = 0; i < part_.size(); ++i) {
        const double share = part_[i].alongMm.norm() / partLengthMm_;
        quality.foreshortening += share * (1.0 - seen[i].sine);
        quality.overlap += share * covered[i];
    }
    return quality;
}

std::vector<double> PartSight::coveredShares(const RigidTransform& cameraFromPatient,
                                             const std::vector<Seen>& part) const
{
    std::vector<Eigen::Vector2d> places;
    std::vector<double> covered;
    double widest = 0.0;
    for (const Seen& seen : part) {
        places.push_back(seen.place);
        covered.push_back(seen.radius < 0.0 ? 1.0 : 0.0);
        widest = std::max(widest, seen.radius);
    }
    std::vector<Seen> others;
    double widestOther = 0.0;
    for (const VesselPiece& piece : all_) {
        others.push_back(seenFrom(cameraFromPatient, piece));
        widestOther = std::max(widestOther, others.back().radius);
    }
    const PlaceCells cells(places, std::max(widest + widestOther, 1e-6));
    for (std::size_t k = 0; k < others.size(); ++k) {
        if (others[k].radius < 0.0) {
            continue;
        }
        cells.near(others[k].place, [&](std::size_t i) {
            const double apart = (part[i].place - others[k].place).norm();
            if (part[i].radius > 0.0 && apart < part[i].radius + others[k].radius && !isTouching(part_[i], all_[k])) {
                covered[i] = std::max(covered[i], coveredWidth(part[i].radius, others[k].radius, apart));
            }
        });
    }
    return covered;
}

Result<PartSight> sightOf(const VesselTree& tree, int branchId, SightOf what)
{
    std::vector<VesselPiece> all = vesselPiecesOf(tree);
    if (what == SightOf::TakeOff) {
        auto takeOff = piecesOfTakeOff(tree, branchId);
        return takeOff ? Result(PartSight(std::move(takeOff).value(), std::move(all))) : takeOff.error();
    }
    std::vector<VesselPiece> branch = piecesOfBranch(all, branchId);
    if (branch.empty()) {
        return Error(messages::noSuchBranch(branchId));
    }
    return PartSight(std::move(branch), std::move(all));
}

}   // namespace angiopose::core
