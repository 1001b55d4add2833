#include "core/registration/alignment/projected_points.h"

#include "core/support/cell_index.h"

#include <algorithm>

namespace angiopose::core {

void ProjectedPoints::reserve(std::size_t count)
{
    next_.reserve(count);
    points_.reserve(count);
}

void ProjectedPoints::reset(int width, int height, double reachPx)
{
    reachPx_ = reachPx;
    cellPx_ = std::max(minCellPx, reachPx);
    columns_ = static_cast<int>(width / cellPx_) + 1;
    rows_ = static_cast<int>(height / cellPx_) + 1;
    first_.reserve(static_cast<std::size_t>((width / minCellPx + 1.0) * (height / minCellPx + 1.0)));
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
    next_.clear();
    points_.clear();
}

void ProjectedPoints::add(const ProjectedPoint& point)
{
    const double column = point.u / cellPx_;
    const double row = point.v / cellPx_;
    if (!(column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_)) {
        return;
    }
    int& first = first_[cellIndex(static_cast<int>(row), columns_, static_cast<int>(column))];
    next_.push_back(first);
    first = static_cast<int>(points_.size());
    points_.push_back(point);
}

const ProjectedPoint* ProjectedPoints::nearest(double u, double v) const
{
    const int column = static_cast<int>(u / cellPx_);
    const int row = static_cast<int>(v / cellPx_);
    const ProjectedPoint* best = nullptr;
    double bestSquared = reachPx_ * reachPx_;
    for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y) {
        for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
            for (int k = first_[cellIndex(y, columns_, x)]; k >= 0; k = next_[static_cast<std::size_t>(k)]) {
                const ProjectedPoint& point = points_[static_cast<std::size_t>(k)];
                const double squared = (point.u - u) * (point.u - u) + (point.v - v) * (point.v - v);
                if (squared < bestSquared) {
                    bestSquared = squared;
                    best = &point;
                }
            }
        }
    }
    return best;
}

}   // namespace angiopose::core
