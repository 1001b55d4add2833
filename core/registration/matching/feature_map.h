#pragma once

#include "core/registration/matching/point_index.h"

#include <algorithm>
#include <cstdint>

namespace angiopose::core {

/// Nearest-point lookup table: Euclidean feature transform (Felzenszwalb, Huttenlocher 2012) on square cells that cover
/// the image and a margin. Each cell stores the result for its center; a lookup is therefore off by at most a cell's
/// diagonal in distance. Queries outside the table use the border cell.
class FeatureMap final : public PointIndex {
public:
    static constexpr int cellPx = 3;

    /// `pointsPx` must be finite and not empty.
    FeatureMap(std::vector<Eigen::Vector2d> pointsPx, int imageWidth, int imageHeight);

    /// Returns the best result of the query's cell and its neighbors; exact if a point lies within one cell.
    std::size_t nearestIndex(const Eigen::Vector2d& queryPx) const override;
    const std::vector<Eigen::Vector2d>& points() const override { return points_; }

    /// Returns the result of the query's cell only, for inner loops.
    std::size_t lookUp(double u, double v) const { return static_cast<std::size_t>(nearest_[cellOf(u, v)]); }

private:
    /// Truncates via int, which is faster than a direct conversion.
    static std::size_t truncated(double value) { return static_cast<std::size_t>(static_cast<int>(value)); }

    std::size_t cellOf(double u, double v) const
    {
        constexpr double perPx = 1.0 / cellPx;
        const double column = std::clamp((u + offsetPx_) * perPx, 0.0, columns_ - 1.0);
        const double row = std::clamp((v + offsetPx_) * perPx, 0.0, rows_ - 1.0);
        return truncated(row) * static_cast<std::size_t>(columns_) + truncated(column);
    }

    std::vector<Eigen::Vector2d> points_;
    double offsetPx_ = 0.0;   ///< added to pixel coordinates so that they count from the outer edge of the first cell
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::int32_t> nearest_;   ///< nearest point per cell, row-major
};

}   // namespace angiopose::core
