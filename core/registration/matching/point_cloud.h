#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// What nanoflann wants to know about points of an image.
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