#pragma once

#include "core/registration/matching/point_index.h"

#include <cstdint>

namespace angiopose::core {

/// Exact nearest-point search in buckets of a few pixels; built in microseconds and fast for queries close to points.
class GridIndex final : public PointIndex {
public:
    /// `pointsPx` must be finite and not empty.
    explicit GridIndex(std::vector<Eigen::Vector2d> pointsPx);

    std::size_t nearestIndex(const Eigen::Vector2d& queryPx) const override;

    /// Overload that starts from the point `guess`; the closer it is to the query, the faster the search.
    std::size_t nearestIndex(const Eigen::Vector2d& queryPx, std::size_t guess) const;

    const std::vector<Eigen::Vector2d>& points() const override { return points_; }

private:
    struct Best;
    void searchRow(int row, double reachPx, const Eigen::Vector2d& queryPx, Best& best) const;
    void searchWithin(const Eigen::Vector2d& queryPx, Best& best) const;

    std::vector<Eigen::Vector2d> points_;
    Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
    double cellPx_ = 1.0;
    double cellsPerPx_ = 1.0;
    int columns_ = 1;
    int rows_ = 1;
    std::vector<std::int32_t> cellStart_;   ///< first entry of each cell in members_, with an end entry
    std::vector<std::int32_t> members_;   ///< point indices grouped by cell
};

}   // namespace angiopose::core
