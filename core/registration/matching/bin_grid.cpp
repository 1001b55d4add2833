#include "core/registration/matching/bin_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr int maxCellsAcross = 1024;

}   // namespace

void BinGrid::fill(const std::vector<Eigen::Vector2d>& pointsPx, double cellPx)
{
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d high = -low;
    for (const Eigen::Vector2d& point : pointsPx) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    if (pointsPx.empty()) {
        low = high = Eigen::Vector2d::Zero();
    }
    origin_ = low;
    cellPx_ = std::max(cellPx, (high - low).maxCoeff() / maxCellsAcross);
    columns_ = static_cast<int>((high - low).x() / cellPx_) + 1;
    rows_ = static_cast<int>((high - low).y() / cellPx_) + 1;

    const auto numberOf = [&](const Eigen::Vector2d& point) {
        const Eigen::Vector2i cell = cellOf(point);
        return cellIndex(cell.y(), columns_, cell.x());
    };
    starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 2, 0);
    for (const Eigen::Vector2d& point : pointsPx) {
        ++starts_[numberOf(point) + 2];
    }
    for (std::size_t i = 2; i < starts_.size(); ++i) {
        starts_[i] += starts_[i - 1];
    }
    numbers_.resize(pointsPx.size());
    for (std::size_t i = 0; i < pointsPx.size(); ++i) {
        numbers_[static_cast<std::size_t>(starts_[numberOf(pointsPx[i]) + 1]++)] = static_cast<std::int32_t>(i);
    }
}

/// Returns the cell of a position, clamped to at most one cell outside the grid to avoid overflow.
Eigen::Vector2i BinGrid::cellOf(const Eigen::Vector2d& positionPx) const
{
    const Eigen::Vector2d cell = (positionPx - origin_) / cellPx_;
    return {static_cast<int>(std::floor(std::clamp(cell.x(), -2.0, columns_ + 1.0))),
            static_cast<int>(std::floor(std::clamp(cell.y(), -2.0, rows_ + 1.0)))};
}

}   // namespace angiopose::core
