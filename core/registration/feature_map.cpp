#include "core/registration/feature_map.h"

#include <cassert>
#include <cmath>

namespace core {
namespace {

constexpr int marginPx = 96;
constexpr std::int32_t none = -1;

/// One parabola of the lower envelope: the column's nearest point, and from which cell on it is the lowest.
struct Parabola {
    int column;
    std::int32_t rowDistanceSquared;
    std::int32_t point;
    double from;
};

/// Row distance to the nearest seed of the same column, for every cell; seeds keep their point.
struct ColumnDistances {
    std::vector<std::int32_t> distance;
    std::vector<std::int32_t> point;
};

ColumnDistances columnDistances(const std::vector<std::int32_t>& seeds, int columns, int rows)
{
    const std::int32_t far = columns + rows;
    const auto width = static_cast<std::size_t>(columns);
    ColumnDistances result{std::vector<std::int32_t>(seeds.size(), far), seeds};
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (seeds[i] != none) {
            result.distance[i] = 0;
        }
    }
    const auto relax = [&result](std::size_t cell, std::size_t neighbour) {
        if (result.distance[neighbour] + 1 < result.distance[cell]) {
            result.distance[cell] = result.distance[neighbour] + 1;
            result.point[cell] = result.point[neighbour];
        }
    };
    for (std::size_t i = width; i < seeds.size(); ++i) {
        relax(i, i - width);
    }
    for (std::size_t i = seeds.size() - width; i-- > 0;) {
        relax(i, i + width);
    }
    return result;
}

/// Lower envelope of the parabolas of one row, written over the row.
void sweepRow(const std::int32_t* distance, const std::int32_t* point, int columns, std::vector<Parabola>& envelope,
              std::int32_t* nearest)
{
    envelope.clear();
    for (int column = 0; column < columns; ++column) {
        if (point[column] == none) {
            continue;
        }
        const std::int32_t squared = distance[column] * distance[column];
        double from = 0.0;
        while (!envelope.empty()) {
            const Parabola& last = envelope.back();
            from =
                static_cast<double>(squared - last.rowDistanceSquared + column * column - last.column * last.column) /
                (2.0 * (column - last.column));
            if (from > last.from) {
                break;
            }
            envelope.pop_back();
        }
        if (envelope.empty()) {
            from = 0.0;
        }
        if (from < columns) {
            envelope.push_back({column, squared, point[column], from});
        }
    }
    std::size_t current = 0;
    for (int column = 0; column < columns; ++column) {
        while (current + 1 < envelope.size() && envelope[current + 1].from <= column) {
            ++current;
        }
        nearest[column] = envelope[current].point;
    }
}

}   // namespace

FeatureMap::FeatureMap(std::vector<Eigen::Vector2d> pointsPx, int imageWidth, int imageHeight)
    : points_(std::move(pointsPx)),
      offsetPx_(marginPx + 0.5),
      columns_((imageWidth + 2 * marginPx + cellPx - 1) / cellPx),
      rows_((imageHeight + 2 * marginPx + cellPx - 1) / cellPx)
{
    assert(!points_.empty());
    std::vector<std::int32_t> seeds(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        // Points outside the table stand at its border, the nearest place that still leads to them.
        const double column = std::clamp((points_[i].x() + offsetPx_) / cellPx, 0.0, columns_ - 1.0);
        const double row = std::clamp((points_[i].y() + offsetPx_) / cellPx, 0.0, rows_ - 1.0);
        const auto cell =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
        seeds[cell] = static_cast<std::int32_t>(i);
    }
    const ColumnDistances byColumn = columnDistances(seeds, columns_, rows_);
    nearest_.resize(seeds.size());
    std::vector<Parabola> envelope;
    envelope.reserve(static_cast<std::size_t>(columns_));
    for (int row = 0; row < rows_; ++row) {
        const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
        sweepRow(&byColumn.distance[start], &byColumn.point[start], columns_, envelope, &nearest_[start]);
    }
}

}   // namespace core
