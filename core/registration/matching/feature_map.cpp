#include "core/registration/matching/feature_map.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace core {
namespace {

constexpr int marginPx = 32;
constexpr std::int32_t none = -1;

/// A row of cells: the nearest point of the same column, or none, and how many rows away it is.
struct Row {
    std::int32_t* point;
    std::int32_t* rowsAway;
};

/// Takes over what the row beside it knows, where that is nearer. Masks instead of branches: compilers make wide
/// instructions of it.
void takeNearer(const Row& here, const Row& beside, std::size_t columns)
{
    for (std::size_t k = 0; k < columns; ++k) {
        const std::int32_t away = beside.rowsAway[k] + 1;
        const std::int32_t taken = away < here.rowsAway[k] ? -1 : 0;
        here.point[k] = (beside.point[k] & taken) | (here.point[k] & ~taken);
        here.rowsAway[k] = (away & taken) | (here.rowsAway[k] & ~taken);
    }
}

/// Spreads every seed up and down its column, as far as no other seed is nearer.
void fillColumns(std::vector<std::int32_t>& point, std::vector<std::int32_t>& rowsAway, std::size_t columns)
{
    const std::size_t rows = point.size() / columns;
    const auto row = [&](std::size_t number) { return Row{&point[number * columns], &rowsAway[number * columns]}; };
    for (std::size_t r = 1; r < rows; ++r) {
        takeNearer(row(r), row(r - 1), columns);
    }
    for (std::size_t r = rows - 1; r-- > 0;) {
        takeNearer(row(r), row(r + 1), columns);
    }
}

/// Lower envelope of the parabolas (squared distance) of one row's columns.
class RowSweep {
public:
    explicit RowSweep(int columns)
        : halfInverse_(static_cast<std::size_t>(columns)), envelope_(static_cast<std::size_t>(columns))
    {
        for (int k = 1; k < columns; ++k) {
            halfInverse_[static_cast<std::size_t>(k)] = 0.5 / k;   // divisions would take half of the time
        }
    }

    void add(int column, std::int32_t squaredRows, std::int32_t point)
    {
        const std::int32_t offset = squaredRows + column * column;
        double from = 0.0;
        while (size_ > 0) {
            const Parabola& last = envelope_[size_ - 1];
            from = static_cast<double>(offset - last.offset) *
                   halfInverse_[static_cast<std::size_t>(column - last.column)];
            if (from > last.from) {
                break;
            }
            --size_;
        }
        if (size_ == 0) {
            from = -1.0;
        }
        if (from < static_cast<double>(halfInverse_.size())) {
            envelope_[size_++] = {from, column, offset, point};
        }
    }

    /// Writes the nearest point of every cell and forgets the row.
    void finish(std::int32_t* nearest)
    {
        int column = 0;
        for (std::size_t k = 0; k < size_; ++k) {
            const auto columns = static_cast<int>(halfInverse_.size());
            const int end = k + 1 < size_ ? static_cast<int>(std::ceil(envelope_[k + 1].from)) : columns;
            for (; column < end; ++column) {
                nearest[column] = envelope_[k].point;
            }
        }
        size_ = 0;
    }

private:
    /// A column's nearest point, and from which cell on it is the nearest of the row.
    struct Parabola {
        double from;
        std::int32_t column;
        std::int32_t offset;   ///< squared rows and squared column
        std::int32_t point;
    };
    std::vector<double> halfInverse_;
    std::vector<Parabola> envelope_;   ///< room for all columns
    std::size_t size_ = 0;
};

}   // namespace

FeatureMap::FeatureMap(std::vector<Eigen::Vector2d> pointsPx, int imageWidth, int imageHeight)
    : points_(std::move(pointsPx)),
      offsetPx_(marginPx + 0.5),
      columns_((imageWidth + 2 * marginPx + cellPx - 1) / cellPx),
      rows_((imageHeight + 2 * marginPx + cellPx - 1) / cellPx)
{
    assert(!points_.empty());
    const auto width = static_cast<std::size_t>(columns_);
    nearest_.assign(width * static_cast<std::size_t>(rows_), none);
    std::vector<std::int32_t> rowsAway(nearest_.size(), 2 * rows_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        // Points outside the table stand at its border, the nearest place that still leads to them.
        const double column = std::clamp((points_[i].x() + offsetPx_) / cellPx, 0.0, columns_ - 1.0);
        const double row = std::clamp((points_[i].y() + offsetPx_) / cellPx, 0.0, rows_ - 1.0);
        const std::size_t cell = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
        nearest_[cell] = static_cast<std::int32_t>(i);
        rowsAway[cell] = 0;
    }
    fillColumns(nearest_, rowsAway, width);
    RowSweep sweep(columns_);
    for (std::size_t row = 0; row < nearest_.size(); row += width) {
        for (int column = 0; column < columns_; ++column) {
            const std::size_t cell = row + static_cast<std::size_t>(column);
            if (nearest_[cell] != none) {
                sweep.add(column, rowsAway[cell] * rowsAway[cell], nearest_[cell]);
            }
        }
        sweep.finish(&nearest_[row]);
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
