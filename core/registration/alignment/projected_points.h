#pragma once

#include <vector>

namespace angiopose::core {

/// Projection of one tree point at one pose.
struct ProjectedPoint {
    double u, v;   ///< px
    int number;   ///< index of the tree point
};

/// Projected points binned by image cell; refilling for a new pose does not allocate.
class ProjectedPoints {
public:
    void reserve(std::size_t count);

    /// Removes all points and sets the search radius of later queries to `reachPx`.
    void reset(int width, int height, double reachPx);

    /// Adds a point unless it lies outside the image.
    void add(const ProjectedPoint& point);

    /// Returns the nearest point within the search radius, or null.
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
