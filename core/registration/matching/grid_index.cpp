#include "core/registration/matching/grid_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double usualCellPx = 4.0;
constexpr double typicalPoints = 4000.0;   // number of points for the default cell size; more points get smaller cells
constexpr double maxCellsPerAxis = 256.0;   // per axis; distant outliers must not cause a huge table
constexpr int maxSearchRows = 31;   // maximum number of rows searched on either side for a first point

}   // namespace

GridIndex::GridIndex(std::vector<Eigen::Vector2d> pointsPx) : points_(std::move(pointsPx))
{
    assert(!points_.empty());
    Eigen::Vector2d highest = points_.front();
    origin_ = points_.front();
    for (const Eigen::Vector2d& point : points_) {
        origin_ = origin_.cwiseMin(point);
        highest = highest.cwiseMax(point);
    }
    const double extentPx = (highest - origin_).maxCoeff();
    const double denser = std::max(1.0, std::sqrt(static_cast<double>(points_.size()) / typicalPoints));
    cellPx_ = std::max(usualCellPx / denser, extentPx / (maxCellsPerAxis * denser - 1.0));
    cellsPerPx_ = 1.0 / cellPx_;
    columns_ = static_cast<int>((highest.x() - origin_.x()) / cellPx_) + 1;
    rows_ = static_cast<int>((highest.y() - origin_.y()) / cellPx_) + 1;

    const auto cellOf = [this](const Eigen::Vector2d& point) {
        const Eigen::Vector2d cell = (point - origin_) / cellPx_;
        return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(cell.x());
    };
    cellStart_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (const Eigen::Vector2d& point : points_) {
        ++cellStart_[cellOf(point) + 1];
    }
    for (std::size_t cell = 1; cell < cellStart_.size(); ++cell) {
        cellStart_[cell] += cellStart_[cell - 1];
    }
    members_.resize(points_.size());
    std::vector<std::int32_t> next(cellStart_.begin(), cellStart_.end() - 1);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        members_[static_cast<std::size_t>(next[cellOf(points_[i])]++)] = static_cast<std::int32_t>(i);
    }
}

/// Current best point of a search.
struct GridIndex::Best {
    std::size_t number = 0;
    double squared = std::numeric_limits<double>::infinity();
};

/// Checks the points of one row of cells, at least those that lie within `reachPx` of the query.
void GridIndex::searchRow(int row, double reachPx, const Eigen::Vector2d& queryPx, Best& best) const
{
    const double middle = queryPx.x() - origin_.x();
    const auto from = static_cast<int>(std::clamp((middle - reachPx) * cellsPerPx_, 0.0, columns_ - 1.0));
    const auto to = static_cast<int>(std::clamp((middle + reachPx) * cellsPerPx_, 0.0, columns_ - 1.0));
    const std::int32_t* const start = &cellStart_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)];
    for (std::int32_t k = start[from]; k < start[to + 1]; ++k) {
        const auto candidate = static_cast<std::size_t>(members_[static_cast<std::size_t>(k)]);
        const double squared = (points_[candidate] - queryPx).squaredNorm();
        if (squared < best.squared || (squared == best.squared && candidate < best.number)) {
            best = {candidate, squared};
        }
    }
}

/// Searches row by row away from the query as long as a point closer than `best` is possible.
void GridIndex::searchWithin(const Eigen::Vector2d& queryPx, Best& best) const
{
    const double place = (queryPx.y() - origin_.y()) * cellsPerPx_;
    const auto middle = static_cast<int>(std::clamp(place, 0.0, rows_ - 1.0));
    for (int row = middle; row >= 0; --row) {
        const double awayPx = std::max(0.0, place - (row + 1)) * cellPx_;
        if (awayPx * awayPx > best.squared) {
            break;
        }
        searchRow(row, std::sqrt(best.squared), queryPx, best);
    }
    for (int row = middle + 1; row < rows_; ++row) {
        const double awayPx = std::max(0.0, row - place) * cellPx_;
        if (awayPx * awayPx > best.squared) {
            break;
        }
        searchRow(row, std::sqrt(best.squared), queryPx, best);
    }
}

std::size_t GridIndex::nearestIndex(const Eigen::Vector2d& queryPx) const
{
    // Finds any point in successively wider bands of rows to limit the search; far from all points, an arbitrary point
    // sets the limit.
    const double place = (queryPx.y() - origin_.y()) * cellsPerPx_;
    const auto middle = static_cast<int>(std::clamp(place, 0.0, rows_ - 1.0));
    Best best;
    for (int reach = 0; reach <= maxSearchRows && !std::isfinite(best.squared); reach = 2 * reach + 1) {
        for (int row = std::max(0, middle - reach); row <= std::min(rows_ - 1, middle + reach); ++row) {
            searchRow(row, (reach + 1) * cellPx_, queryPx, best);
        }
    }
    return nearestIndex(queryPx, best.number);
}

std::size_t GridIndex::nearestIndex(const Eigen::Vector2d& queryPx, std::size_t guess) const
{
    Best best{guess, (points_[guess] - queryPx).squaredNorm()};
    const auto isNearer = [&](std::size_t number) {
        const double squared = (points_[number] - queryPx).squaredNorm();
        return squared < best.squared ? (best = {number, squared}, true) : false;
    };
    while (best.number + 1 < points_.size() && isNearer(best.number + 1)) {
    }
    while (best.number > 0 && isNearer(best.number - 1)) {
    }
    searchWithin(queryPx, best);
    return best.number;
}

}   // namespace angiopose::core
