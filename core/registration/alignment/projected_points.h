#pragma once

#include <vector>

namespace angiopose::core {

/// A tree point as one pose shows it.
struct ProjectedPoint {
    double u, v;   ///< px
    int number;   ///< of the tree point
};

/// Projected points by cells of the image, filled anew for every pose without asking for memory.
class ProjectedPoints {
public:
    /// Room for `count` points.
    void reserve(std::size_t count);

    /// Forgets the points; neighbours are from now on sought within `reachPx`.
    void restart(int width, int height, double reachPx);

    /// Points outside the image are left out.
    void add(const ProjectedPoint& point);

    /// The nearest point within the reach, or null.
    const ProjectedPoint* nearest(double u, double v) const;

private:
    static constexpr double minCellPx = 4.0;

    double reachPx_ = minCellPx;
    double cellPx_ = minCellPx;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<int> first_;   ///< of each cell, −1 for none
    std::vector<int> next_;   ///< of each point, in its cell
    std::vector<ProjectedPoint> points_;
};

}   // namespace angiopose::core