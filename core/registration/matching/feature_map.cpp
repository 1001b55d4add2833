#include "core/registration/matching/feature_map.h"

#include <cassert>
#include <cstdlib>
#include <limits>

namespace core {
namespace {

constexpr int marginPx = 64;
constexpr std::int32_t none = -1;

/// One parabola of the lower envelope: the column's nearest point, and from which cell on it is the lowest.
struct Parabola {
    int column;
    std::int32_t squaredRows;
    std::int32_t point;
    double from;
};

/// Spreads every seed up and down its column, as far as no other seed is nearer.
void fillColumns(std::vector<std::int32_t>& cells, const std::vector<std::int32_t>& rowOfPoint, int columns, int rows)
{
    const auto width = static_cast<std::size_t>(columns);
    for (std::size_t i = width; i < cells.size(); ++i) {
        if (cells[i] == none) {
            cells[i] = cells[i - width];
        }
    }
    for (int row = rows - 2; row >= 0; --row) {
        std::int32_t* here = &cells[static_cast<std::size_t>(row) * width];
        const std::int32_t* below = here + width;
        for (std::size_t column = 0; column < width; ++column) {
            if (below[column] == none || below[column] == here[column]) {
                continue;
            }
            const auto distanceTo = [&](std::int32_t point) {
                return std::abs(rowOfPoint[static_cast<std::size_t>(point)] - row);
            };
            if (here[column] == none || distanceTo(below[column]) < distanceTo(here[column])) {
                here[column] = below[column];
            }
        }
    }
}

/// Lower envelope of the parabolas of one row.
class RowSweep {
public:
    explicit RowSweep(int columns) : halfInverse_(static_cast<std::size_t>(columns))
    {
        for (int k = 1; k < columns; ++k) {
            halfInverse_[static_cast<std::size_t>(k)] = 0.5 / k;   // divisions would take half of the time
        }
        envelope_.reserve(halfInverse_.size());
    }

    void add(int column, std::int32_t squaredRows, std::int32_t point)
    {
        double from = 0.0;
        while (!envelope_.empty()) {
            const Parabola& last = envelope_.back();
            from = static_cast<double>(squaredRows - last.squaredRows + column * column - last.column * last.column) *
                   halfInverse_[static_cast<std::size_t>(column - last.column)];
            if (from > last.from) {
                break;
            }
            envelope_.pop_back();
        }
        if (envelope_.empty()) {
            from = 0.0;
        }
        if (from < static_cast<double>(halfInverse_.size())) {
            envelope_.push_back({column, squaredRows, point, from});
        }
    }

    /// Writes the nearest point of every cell and forgets the row.
    void finish(std::int32_t* nearest)
    {
        std::size_t current = 0;
        for (std::size_t column = 0; column < halfInverse_.size(); ++column) {
            while (current + 1 < envelope_.size() && envelope_[current + 1].from <= static_cast<double>(column)) {
                ++current;
            }
            nearest[column] = envelope_[current].point;
        }
        envelope_.clear();
    }

private:
    std::vector<double> halfInverse_;
    std::vector<Parabola> envelope_;
};

}   // namespace

FeatureMap::FeatureMap(std::vector<Eigen::Vector2d> pointsPx, int imageWidth, int imageHeight)
    : points_(std::move(pointsPx)),
      offsetPx_(marginPx + 0.5),
      columns_((imageWidth + 2 * marginPx + cellPx - 1) / cellPx),
      rows_((imageHeight + 2 * marginPx + cellPx - 1) / cellPx)
{
    assert(!points_.empty());
    nearest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none);
    std::vector<std::int32_t> rowOfPoint(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        // Points outside the table stand at its border, the nearest place that still leads to them.
        const double column = std::clamp((points_[i].x() + offsetPx_) / cellPx, 0.0, columns_ - 1.0);
        const double row = std::clamp((points_[i].y() + offsetPx_) / cellPx, 0.0, rows_ - 1.0);
        rowOfPoint[i] = static_cast<std::int32_t>(row);
        nearest_[static_cast<std::size_t>(rowOfPoint[i]) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(column)] = static_cast<std::int32_t>(i);
    }
    fillColumns(nearest_, rowOfPoint, columns_, rows_);
    RowSweep sweep(columns_);
    for (int row = 0; row < rows_; ++row) {
        std::int32_t* cells = &nearest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)];
        for (int column = 0; column < columns_; ++column) {
            if (cells[column] != none) {
                const std::int32_t rowsAway = rowOfPoint[static_cast<std::size_t>(cells[column])] - row;
                sweep.add(column, rowsAway * rowsAway, cells[column]);
            }
        }
        sweep.finish(cells);
    }
}

std::size_t FeatureMap::nearestIndex(const Eigen::Vector2d& queryPx) const
{
    const auto cellOf = [this](double px, int count) {
        return static_cast<int>(std::clamp((px + offsetPx_) / cellPx, 0.0, count - 1.0));
    };
    const int column = cellOf(queryPx.x(), columns_);
    const int row = cellOf(queryPx.y(), rows_);
    std::size_t best = 0;
    double bestSquared = std::numeric_limits<double>::infinity();
    for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
        for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
            const auto candidate = static_cast<std::size_t>(nearest_[static_cast<std::size_t>(r * columns_ + c)]);
            const double squared = (points_[candidate] - queryPx).squaredNorm();
            if (squared < bestSquared) {
                bestSquared = squared;
                best = candidate;
            }
        }
    }
    return best;
}

}   // namespace core
