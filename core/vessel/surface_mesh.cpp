#include "core/vessel/surface_mesh.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace angiopose::core {
namespace {

constexpr std::size_t weldProgressMask = 0xFFFF;   ///< bit mask: points between checks for cancellation, minus one

/// Undirected edge of a triangle, and whether the triangle traverses the edge in ascending order.
struct HalfEdge {
    std::uint32_t low, high;
    bool isUpward;
};

std::vector<HalfEdge> halfEdgesOf(const SurfaceMesh& mesh)
{
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), from < to});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const HalfEdge& a, const HalfEdge& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
    return edges;
}

}   // namespace

MeshCheck checkMesh(const SurfaceMesh& mesh)
{
    MeshCheck check;
    check.isOriented = true;
    const std::vector<HalfEdge> edges = halfEdgesOf(mesh);
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first;
        int upward = 0;
        for (; end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high;
             ++end) {
            upward += edges[end].isUpward ? 1 : -1;
        }
        const std::size_t count = end - first;
        check.boundaryEdges += count == 1 ? 1 : 0;
        check.nonManifoldEdges += count > 2 ? 1 : 0;
        check.isOriented = check.isOriented && (count == 1 || upward == 0);
        first = end;
    }
    return check;
}

SurfaceMesh weldPoints(const SurfaceMesh& mesh, const std::function<bool()>& shouldContinue)
{
    SurfaceMesh result;
    std::map<std::tuple<double, double, double>, std::uint32_t> indexByPosition;
    std::vector<std::uint32_t> merged;
    merged.reserve(mesh.pointsInPatient.size());
    for (const Eigen::Vector3d& point : mesh.pointsInPatient) {
        if ((merged.size() & weldProgressMask) == 0 && shouldContinue && !shouldContinue()) {
            return {};
        }
        const auto [place, isNew] = indexByPosition.try_emplace(
            {point.x(), point.y(), point.z()}, static_cast<std::uint32_t>(result.pointsInPatient.size()));
        if (isNew) {
            result.pointsInPatient.push_back(point);
        }
        merged.push_back(place->second);
    }
    for (const auto& triangle : mesh.triangles) {
        const std::array<std::uint32_t, 3> corners = {merged[triangle[0]], merged[triangle[1]], merged[triangle[2]]};
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2]) {
            result.triangles.push_back(corners);
        }
    }
    return result;
}

}   // namespace angiopose::core
