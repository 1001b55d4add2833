#include "core/registration/matching/feature_map.h"

#include "core/support/cell_index.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr int mapMarginPx = 8;
constexpr std::int32_t noFeature = -1;
constexpr std::int16_t far = 20000;   // number of cells that stands for no distance; its square fits in 32 bits

/// Returns the number of rows to the nearest seed in the same column, or `far` if there is none. Uses two bytes per
/// cell and no branches, so that compilers can vectorize it.
std::vector<std::int16_t> rowsToSeed(const std::vector<std::int32_t>& seeds, std::size_t columns)
{
    std::vector<std::int16_t> away(seeds.size());
    for (std::size_t cell = 0; cell < seeds.size(); ++cell) {
        away[cell] = seeds[cell] == noFeature ? far : std::int16_t{0};
    }
    const auto takeNearer = [&](std::size_t here, std::size_t beside) {
        for (std::size_t k = 0; k < columns; ++k) {
            away[here + k] = std::min(away[here + k], static_cast<std::int16_t>(away[beside + k] + 1));
        }
    };
    for (std::size_t here = columns; here < away.size(); here += columns) {
        takeNearer(here, here - columns);
    }
    for (std::size_t here = away.size() - columns; here > 0; here -= columns) {
        takeNearer(here - columns, here);
    }
    return away;
}

/// Computes the lower envelope of the parabolas (squared distances) of the columns in one row.
class RowSweep {
public:
    explicit RowSweep(int columns)
        : columns_(columns),
          squared_(static_cast<std::size_t>(columns) + 2, farSquared),
          halfInverse_(static_cast<std::size_t>(columns)),
          candidates_(static_cast<std::size_t>(columns)),
          envelope_(static_cast<std::size_t>(columns))
    {
        for (int k = 1; k < columns; ++k) {
            halfInverse_[static_cast<std::size_t>(k)] = 0.5 / k;   // divisions would take half of the run time
        }
    }

    /// Calls `fill(from, to, column)` for the cells from … to − 1 nearest to the seed of `column`, along the whole row.
    template <class Fill>
    void run(const std::int16_t* rowsAway, const Fill& fill)
    {
        for (int k = 0; k < columns_; ++k) {
            squared_[static_cast<std::size_t>(k) + 1] = rowsAway[k] * rowsAway[k];
        }
        size_ = 0;
        for (std::size_t k = 0, count = findCandidates(); k < count; ++k) {
            add(candidates_[k]);
        }
        int from = 0;
        for (std::size_t k = 0; k < size_; ++k) {
            const int to = k + 1 < size_ ? static_cast<int>(std::ceil(envelope_[k + 1].from)) : columns_;
            fill(from, to, envelope_[k].column);
            from = std::max(from, to);
        }
    }

private:
    static constexpr std::int32_t farSquared = far * far;

    /// Finds the columns that may be nearest to some cell, by comparison with their direct neighbors only; eliminates
    /// most columns without a branch.
    std::size_t findCandidates()
    {
        std::size_t count = 0;
        for (int k = 0; k < columns_; ++k) {
            const std::int32_t* const here = &squared_[static_cast<std::size_t>(k) + 1];
            const std::int32_t first = (here[0] - here[-1]) >> 1;   // index of the cell, relative to the column
            const std::int32_t last = (here[1] - here[0] + 1) >> 1;
            candidates_[count] = k;
            count += static_cast<std::size_t>(here[0] < farSquared) & static_cast<std::size_t>(first <= last);
        }
        return count;
    }

    void add(int column)
    {
        const std::int32_t offset = squared_[static_cast<std::size_t>(column) + 1] + column * column;
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
        if (from < static_cast<double>(columns_)) {
            envelope_[size_++] = {from, column, offset};
        }
    }

    /// Parabola of a column's seed, and the first cell in the row for which it is the nearest.
    struct Parabola {
        double from;
        std::int32_t column;
        std::int32_t offset;   ///< squared row distance plus squared column
    };
    int columns_;
    std::vector<std::int32_t> squared_;   ///< squared row distances to the seeds, padded by one column on both sides
    std::vector<double> halfInverse_;
    std::vector<int> candidates_;
    std::vector<Parabola> envelope_;   ///< allocated for the maximum number of columns
    std::size_t size_ = 0;
};

}   // namespace

FeatureMap::FeatureMap(std::vector<Eigen::Vector2d> pointsPx, int imageWidth, int imageHeight)
    : points_(std::move(pointsPx)),
      offsetPx_(mapMarginPx + 0.5),
      columns_((imageWidth + 2 * mapMarginPx + cellPx - 1) / cellPx),
      rows_((imageHeight + 2 * mapMarginPx + cellPx - 1) / cellPx)
{
    assert(!points_.empty());
    const auto width = static_cast<std::size_t>(columns_);
    std::vector<std::int32_t> seeds(width * static_cast<std::size_t>(rows_), noFeature);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        // Assigns points outside the table to the nearest border cell, where lookups still find them.
        seeds[cellOf(points_[i].x(), points_[i].y())] = static_cast<std::int32_t>(i);
    }
    const std::vector<std::int16_t> rowsAway = rowsToSeed(seeds, width);
    nearest_.resize(seeds.size());
    RowSweep sweep(columns_);
    for (std::size_t row = 0; row < nearest_.size(); row += width) {
        sweep.run(&rowsAway[row], [&](int from, int to, int column) {
            const std::size_t cell = row + static_cast<std::size_t>(column);
            const std::size_t rows = width * static_cast<std::size_t>(rowsAway[cell]);
            const bool isAbove = rows <= cell && seeds[cell - rows] != noFeature;
            std::fill(nearest_.begin() + static_cast<std::ptrdiff_t>(row) + from,
                      nearest_.begin() + static_cast<std::ptrdiff_t>(row) + std::max(from, to),
                      seeds[isAbove ? cell - rows : cell + rows]);
        });
    }
}

std::size_t FeatureMap::nearestIndex(const Eigen::Vector2d& queryPx) const
{
    const auto cell = static_cast<int>(cellOf(queryPx.x(), queryPx.y()));
    const int column = cell % columns_;
    const int row = cell / columns_;
    std::size_t best = 0;
    double bestSquared = std::numeric_limits<double>::infinity();
    for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
        for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
            const auto candidate = static_cast<std::size_t>(nearest_[cellIndex(r, columns_, c)]);
            const double squared = (points_[candidate] - queryPx).squaredNorm();
            if (squared < bestSquared) {
                bestSquared = squared;
                best = candidate;
            }
        }
    }
    return best;
}

}   // namespace angiopose::core
