#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Adaptor that gives nanoflann access to image points.
struct PointCloud {
    std::vector<Eigen::Vector2d> points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t index, std::size_t axis) const
    {
        return points[index](static_cast<Eigen::Index>(axis));
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const
    {
        return false;
    }
};

}   // namespace angiopose::core
