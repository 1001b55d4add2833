#pragma once

#include <vector>

namespace angiopose::core {

/// Tree point projected under one pose.
struct ProjectedPoint {
    double u, v;   ///< px
    int number;   ///< index of the tree point
};

/// Projected points binned by image cells; refilled for every pose without allocating.
class ProjectedPoints {
public:
    /// Reserves memory for `count` points.
    void reserve(std::size_t count);

    /// Removes all points; later queries look for neighbors within `reachPx`.
    void restart(int width, int height, double reachPx);

    /// Adds a point; ignores points outside the image.
    void add(const ProjectedPoint& point);

    /// Nearest point within the search radius, or null.
    const ProjectedPoint* nearest(double u, double v) const;

private:
    static constexpr double minCellPx = 4.0;

    double reachPx_ = minCellPx;
    double cellPx_ = minCellPx;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<int> first_;   ///< first point of each cell, −1 for none
    std::vector<int> next_;   ///< next point in the same cell, per point
    std::vector<ProjectedPoint> points_;
};

}   // namespace angiopose::core