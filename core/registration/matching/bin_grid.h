#pragma once

#include "core/support/cell_index.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Bins image points into square cells for queries near a position. Refilling does not allocate once the buffers are
/// large enough.
class BinGrid {
public:
    /// Fills the grid with finite points; `cellPx` is the cell size and the search radius of `visitNear`.
    void fill(const std::vector<Eigen::Vector2d>& pointsPx, double cellPx);

    /// Calls `visit(number)` for all points in the nine cells around a position, including all points within `cellPx`.
    template <class Visit>
    void visitNear(const Eigen::Vector2d& positionPx, const Visit& visit) const
    {
        const Eigen::Vector2i cell = cellOf(positionPx);
        const int fromRow = std::max(0, cell.y() - 1);
        const int toRow = std::min(rows_ - 1, cell.y() + 1);
        const int fromColumn = std::max(0, cell.x() - 1);
        const int toColumn = std::min(columns_ - 1, cell.x() + 1);
        for (int row = fromRow; row <= toRow && fromColumn <= toColumn; ++row) {
            const std::size_t first = cellIndex(row, columns_, fromColumn);
            const std::size_t last = cellIndex(row, columns_, toColumn);
            for (std::int32_t k = starts_[first]; k < starts_[last + 1]; ++k) {
                visit(static_cast<std::size_t>(numbers_[static_cast<std::size_t>(k)]));
            }
        }
    }

private:
    Eigen::Vector2i cellOf(const Eigen::Vector2d& positionPx) const;

    Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
    double cellPx_ = 1.0;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::int32_t> starts_;   ///< first entry of each cell in row-major order, with an end entry
    std::vector<std::int32_t> numbers_;
};

}   // namespace angiopose::core
