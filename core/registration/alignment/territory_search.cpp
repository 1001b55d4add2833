#include "core/registration/alignment/territory_search.h"

#include "core/geometry/angle_units.h"
#include "core/registration/alignment/for_each_rotation.h"
#include "core/support/cell_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr int minCellPx = 8;
constexpr int cellsAcrossImage = 128;   // maximum number of cells per side; larger images get larger cells
constexpr int stampReach = 3;   // cells
constexpr double stampScale = 1.4;   // cells
constexpr double otherWidthCloseness =
    0.4;   // closeness assigned to a vessel of a different width at the right position
constexpr double widthStep = 0.5;   // bin width in log vessel width
constexpr double minTraceableRadiusPx = 1.0;   // minimum radius; thinner vessels are not traced
constexpr double widestPx = 60.0;
constexpr double maxWidthDifference = 0.75;   // maximum difference in log width between matching widths
constexpr std::size_t maxTargetPoints = 150;   // number of target points; at most 257 keep sums of bytes within 16 bits
constexpr double minChannelCosine = 0.84;   // minimum cosine to a channel's direction; cos 33°
constexpr double minTerritoryProjection = 0.3;   // vessels nearly along the ray have no direction
constexpr std::size_t keptPerTurn = 3;
constexpr double minShiftSpacing = 3.0;   // minimum spacing of the shifts kept per rotation
constexpr double basinCells = 3.0;
constexpr double basinOfStep = 0.75;
constexpr double maxShiftShare = 0.6;   // maximum shift as a fraction of the image side

/// Unit vectors at 0°, 45°, 90° and 135°.
const std::array<Eigen::Vector2d, 4> channelDirections{
    Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0),
    Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(-std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0)};

std::size_t nearestDirection(const Eigen::Vector2d& direction)
{
    const auto best = std::ranges::max_element(
        channelDirections, {}, [&](const Eigen::Vector2d& channel) { return std::abs(channel.dot(direction)); });
    return static_cast<std::size_t>(best - channelDirections.begin());
}

}   // namespace

/// Scores of all shifts for one orientation; the first entry is the largest shift down and to the right.
struct TerritorySearch::Shifts {
    int halfColumns;
    int halfRows;
    int columns;
    int rows;
    std::vector<std::uint16_t> sums;

    Shifts(int half, const PoseFreedom& freedom)
        : halfColumns(freedom.isLocked(PoseAxis::Right) ? 0 : half),
          halfRows(freedom.isLocked(PoseAxis::Up) ? 0 : half),
          columns(2 * halfColumns + 1),
          rows(2 * halfRows + 1),
          sums(cellIndex(rows, columns, 0))
    {
    }
};

TerritorySearch::TerritorySearch(const ProjectionCamera& camera, const TargetLines& target,
                                 std::span<const double> radiusPx)
    : camera_(camera), cellPx_(std::max(minCellPx, std::max(camera.width, camera.height) / cellsAcrossImage))
{
    const std::vector<TargetLines::Line>& lines = target.lines();
    const std::size_t count = std::min(maxTargetPoints, lines.size());
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t number = k * lines.size() / count;
        const TargetLines::Line& line = lines[number];
        const Eigen::Vector2d cell = Eigen::Vector2d(line.x, line.y) / cellPx_;
        if (cell.minCoeff() >= 0.0 && cell.x() < camera.width / cellPx_ && cell.y() < camera.height / cellPx_) {
            const std::size_t width = widthBin(radiusPx.empty() ? 0.0 : radiusPx[number]);
            targetPoints_.push_back({static_cast<int>(cell.x()), static_cast<int>(cell.y()),
                                     width * directions + nearestDirection({line.tx, line.ty})});
        }
    }
    for (int row = -stampReach; row <= stampReach; ++row) {
        for (int column = -stampReach; column <= stampReach; ++column) {
            const double closeness = std::exp(-0.5 * (row * row + column * column) / (stampScale * stampScale));
            sameWidthStamp_.push_back(static_cast<std::uint8_t>(std::lround(255.0 * closeness)));
            otherWidthStamp_.push_back(static_cast<std::uint8_t>(std::lround(255.0 * otherWidthCloseness * closeness)));
        }
    }
}

/// Returns the index of a width bin; adds the bin if it is new.
std::size_t TerritorySearch::widthBin(double radiusPx)
{
    const double logWidth =
        radiusPx > 0.0
            ? widthStep * std::round(std::log(std::clamp(radiusPx, minTraceableRadiusPx, widestPx)) / widthStep)
            : std::numeric_limits<double>::quiet_NaN();
    const auto known = std::ranges::find_if(
        logWidths_, [&](double other) { return other == logWidth || (std::isnan(other) && std::isnan(logWidth)); });
    if (known == logWidths_.end()) {
        logWidths_.push_back(logWidth);
        return logWidths_.size() - 1;
    }
    return static_cast<std::size_t>(known - logWidths_.begin());
}

/// Marks which target widths match which tree points; an unknown width matches all.
void TerritorySearch::compareWidths(std::span<const double> radiusMm, double pxPerMm, std::size_t points)
{
    widthsMatch_.assign(points * logWidths_.size(), 1);
    for (std::size_t k = 0; k < radiusMm.size(); ++k) {
        const double logExpected = std::log(std::clamp(radiusMm[k] * pxPerMm, minTraceableRadiusPx, widestPx));
        for (std::size_t width = 0; width < logWidths_.size() && radiusMm[k] > 0.0; ++width) {
            widthsMatch_[k * logWidths_.size() + width] =
                !(std::abs(logWidths_[width] - logExpected) > maxWidthDifference);
        }
    }
}

void TerritorySearch::allocateCanvas(int halfShift)
{
    margin_ = halfShift;
    columns_ = camera_.width / cellPx_ + 1 + 2 * margin_;
    rows_ = camera_.height / cellPx_ + 1 + 2 * margin_;
    canvas_.resize(directions * logWidths_.size() * cellIndex(rows_, columns_, 0));
}

void TerritorySearch::stamp(int column, int row, const Stamp& closeness, std::uint8_t* channel) const
{
    constexpr int width = 2 * stampReach + 1;
    for (int r = 0; r < width; ++r) {
        const std::uint8_t* source = &closeness[cellIndex(r, width, 0)];
        std::uint8_t* to = channel + cellIndex(row + r - stampReach, columns_, column - stampReach);
        for (int c = 0; c < width; ++c) {
            to[c] = std::max(to[c], source[c]);
        }
    }
}

void TerritorySearch::drawTree(std::span<const AlignmentPoint> points, const CentroidPose& pose)
{
    std::fill(canvas_.begin(), canvas_.end(), std::uint8_t{0});
    const std::size_t widths = logWidths_.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
        const AlignmentPoint& point = points[k];
        const Eigen::Vector3d X = pose.rotation * point.fromCentroid + pose.centroidInCamera;
        const auto pixel = project(camera_, X);
        if (!pixel) {
            continue;
        }
        const Eigen::Vector2d cell = *pixel / cellPx_ + Eigen::Vector2d::Constant(margin_);
        if (!(cell.minCoeff() >= stampReach && cell.x() < columns_ - stampReach && cell.y() < rows_ - stampReach)) {
            continue;
        }
        const Eigen::Vector3d tangent = pose.rotation * point.tangent;
        const Eigen::Vector2d along(camera_.fx * (tangent.x() - X.x() / X.z() * tangent.z()),
                                    camera_.fy * (tangent.y() - X.y() / X.z() * tangent.z()));
        const bool isEndOn = along.norm() < minTerritoryProjection * camera_.fy;
        const double least = isEndOn ? -1.0 : minChannelCosine * along.norm();
        for (std::size_t channel = 0; channel < widths * directions; ++channel) {
            if (std::abs(channelDirections[channel % directions].dot(along)) >= least) {
                const bool isLike = widthsMatch_[k * widths + channel / directions] != 0;
                stamp(static_cast<int>(cell.x()), static_cast<int>(cell.y()),
                      isLike ? sameWidthStamp_ : otherWidthStamp_, &canvas_[channel * cellIndex(rows_, columns_, 0)]);
            }
        }
    }
}

void TerritorySearch::sumShifts(Shifts& shifts) const
{
    std::fill(shifts.sums.begin(), shifts.sums.end(), std::uint16_t{0});
    for (const TargetPoint& place : targetPoints_) {
        const std::uint8_t* channel = &canvas_[place.channel * cellIndex(rows_, columns_, 0)];
        const int firstRow = place.row + margin_ - shifts.halfRows;
        const int firstColumn = place.column + margin_ - shifts.halfColumns;
        for (int r = 0; r < shifts.rows; ++r) {
            const std::uint8_t* source = channel + cellIndex(firstRow + r, columns_, firstColumn);
            std::uint16_t* sum = &shifts.sums[cellIndex(r, shifts.columns, 0)];
            for (int c = 0; c < shifts.columns; ++c) {
                sum[c] = static_cast<std::uint16_t>(sum[c] + source[c]);
            }
        }
    }
}

void TerritorySearch::keepBest(const CentroidPose& pose, const Shifts& shifts,
                               std::vector<CoarseCandidate>& candidates) const
{
    struct Peak {
        int column, row;
    };
    std::vector<Peak> kept;
    const double depthMm = pose.centroidInCamera.z();
    while (kept.size() < keptPerTurn) {
        int highest = -1;
        Peak best{};
        for (int row = 0; row < shifts.rows; ++row) {
            for (int column = 0; column < shifts.columns; ++column) {
                const int sum = shifts.sums[cellIndex(row, shifts.columns, column)];
                const auto isBeside = [&](const Peak& peak) {
                    return std::hypot(peak.column - column, peak.row - row) < minShiftSpacing;
                };
                if (sum > highest && std::ranges::none_of(kept, isBeside)) {
                    highest = sum;
                    best = {column, row};
                }
            }
        }
        if (highest < 0) {
            return;
        }
        kept.push_back(best);
        CoarseCandidate candidate{pose, highest / (255.0 * static_cast<double>(targetPoints_.size()))};
        candidate.pose.centroidInCamera.x() += (shifts.halfColumns - best.column) * cellPx_ * depthMm / camera_.fx;
        candidate.pose.centroidInCamera.y() += (shifts.halfRows - best.row) * cellPx_ * depthMm / camera_.fy;
        candidates.push_back(candidate);
    }
}

std::vector<CoarseCandidate> TerritorySearch::find(std::span<const AlignmentPoint> points,
                                                   std::span<const double> radiusMm, const CentroidPose& start,
                                                   const SearchRange& range,
                                                   const std::function<ObserverDecision(double)>& observe)
{
    std::vector<CoarseCandidate> candidates;
    if (targetPoints_.empty()) {
        return candidates;
    }
    const double depthMm = std::max(minProjectableDepthMm, start.centroidInCamera.z());
    const double pxPerMm = 1.0 / millimetersPerPixel(camera_, depthMm);
    const double radiusPx = std::min(range.radiusMm * pxPerMm, maxShiftShare * std::max(camera_.width, camera_.height));
    const int half = static_cast<int>(std::ceil(radiusPx / cellPx_));
    Shifts shifts(half, range.freedom);
    allocateCanvas(half);
    compareWidths(radiusMm, pxPerMm, points.size());
    forEachRotation(
        start, range,
        [&](const CentroidPose& pose) {
            drawTree(points, pose);
            sumShifts(shifts);
            keepBest(pose, shifts, candidates);
        },
        observe);
    return distinctCandidates(std::move(candidates),
                              {basinCells * cellPx_ / pxPerMm, basinOfStep * range.stepDeg * radiansPerDegree});
}

}   // namespace angiopose::core
