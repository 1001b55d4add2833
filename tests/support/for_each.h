#pragma once

#include <Eigen/Core>

namespace angiopose::test {

/// Calls `visit(i, j, k)` for the voxels from `low` to below `high`, i fastest.
template <class Visit>
void forEachVoxel(const Eigen::Vector3i& low, const Eigen::Vector3i& high, const Visit& visit)
{
    for (int k = low.z(); k < high.z(); ++k) {
        for (int j = low.y(); j < high.y(); ++j) {
            for (int i = low.x(); i < high.x(); ++i) {
                visit(i, j, k);
            }
        }
    }
}

template <class Visit>
void forEachVoxel(const Eigen::Vector3i& size, const Visit& visit)
{
    forEachVoxel({0, 0, 0}, size, visit);
}

/// Calls `visit(x, y)` for the pixels from `low` to below `high`, row by row.
template <class Visit>
void forEachPixel(const Eigen::Vector2i& low, const Eigen::Vector2i& high, const Visit& visit)
{
    for (int y = low.y(); y < high.y(); ++y) {
        for (int x = low.x(); x < high.x(); ++x) {
            visit(x, y);
        }
    }
}

template <class Visit>
void forEachPixel(int width, int height, const Visit& visit)
{
    forEachPixel({0, 0}, {width, height}, visit);
}

}   // namespace angiopose::test
