#include "core/registration/matching/grid_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace core {
namespace {

constexpr int maxCellsPerAxis = 256;   // far outliers must not ask for a huge table

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
    cellPx_ = std::max(cellPx_, extentPx / (maxCellsPerAxis - 1));
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

std::size_t GridIndex::nearestIndex(const Eigen::Vector2d& queryPx) const
{
    const Eigen::Vector2d cell = (queryPx - origin_) / cellPx_;
    const int column = static_cast<int>(std::clamp(std::floor(cell.x()), 0.0, columns_ - 1.0));
    const int row = static_cast<int>(std::clamp(std::floor(cell.y()), 0.0, rows_ - 1.0));
    double bestSquared = std::numeric_limits<double>::infinity();
    std::int32_t best = 0;
    const auto visit = [&](int c, int r) {
        const auto index =
            static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
        for (std::int32_t k = cellStart_[index]; k < cellStart_[index + 1]; ++k) {
            const std::int32_t candidate = members_[static_cast<std::size_t>(k)];
            const double squared = (points_[static_cast<std::size_t>(candidate)] - queryPx).squaredNorm();
            if (squared < bestSquared || (squared == bestSquared && candidate < best)) {
                bestSquared = squared;
                best = candidate;
            }
        }
    };
    // Rings of cells around the query; one more ring cannot help once the best is nearer than the ring.
    const double column0 = cell.x() - column;
    const double row0 = cell.y() - row;
    const double edge = std::min({column0, 1.0 - column0, row0, 1.0 - row0});   // negative outside the table
    for (int ring = 0; ring <= std::max(columns_, rows_); ++ring) {
        const double reachPx = std::max(0.0, (ring - 1 + std::min(edge, 1.0)) * cellPx_);
        if (ring > 0 && reachPx * reachPx > bestSquared) {
            break;
        }
        for (int r = std::max(0, row - ring); r <= std::min(rows_ - 1, row + ring); ++r) {
            const bool isEdge = r == row - ring || r == row + ring;
            const int step = isEdge || ring == 0 ? 1 : 2 * ring;
            for (int c = column - ring; c <= column + ring; c += step) {
                if (c >= 0 && c < columns_) {
                    visit(c, r);
                }
            }
        }
    }
    return static_cast<std::size_t>(best);
}

}   // namespace core
