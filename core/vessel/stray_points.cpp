#include "core/vessel/stray_points.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double maxStrayFraction = 0.01;

/// Returns the median of the points along each axis, ignoring non-finite points.
Eigen::Vector3d componentwiseMedian(const std::vector<Eigen::Vector3d>& points)
{
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        values.reserve(points.size());
        for (const Eigen::Vector3d& point : points) {
            if (point.allFinite()) {
                values.push_back(point[axis]);
            }
        }
        if (!values.empty()) {
            const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::nth_element(values.begin(), half, values.end());
            middle[axis] = *half;
        }
    }
    return middle;
}

}   // namespace

std::size_t removeStrayPoints(SurfaceMesh& mesh)
{
    const Eigen::Vector3d middle = componentwiseMedian(mesh.pointsInPatient);
    constexpr std::uint32_t removedIndex = 0xFFFFFFFFU;
    std::vector<std::uint32_t> newIndices;
    newIndices.reserve(mesh.pointsInPatient.size());
    std::uint32_t next = 0;
    for (const Eigen::Vector3d& point : mesh.pointsInPatient) {
        const bool isNear = point.allFinite() && (point - middle).norm() <= maxBodySizeMm;
        newIndices.push_back(isNear ? next++ : removedIndex);
    }
    const std::size_t stray = newIndices.size() - next;
    if (stray == 0 || static_cast<double>(stray) > maxStrayFraction * static_cast<double>(newIndices.size())) {
        return 0;
    }
    for (std::size_t n = 0; n < newIndices.size(); ++n) {
        if (newIndices[n] != removedIndex) {
            mesh.pointsInPatient[newIndices[n]] = mesh.pointsInPatient[n];
        }
    }
    mesh.pointsInPatient.resize(next);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
        if (newIndices[a] != removedIndex && newIndices[b] != removedIndex && newIndices[c] != removedIndex) {
            triangles.push_back({newIndices[a], newIndices[b], newIndices[c]});
        }
    }
    mesh.triangles = std::move(triangles);
    return stray;
}

}   // namespace angiopose::core
