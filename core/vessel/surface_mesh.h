#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace angiopose::core {

/// The vessel wall as a triangle mesh, in patient LPS, mm.
struct SurfaceMesh {
    std::vector<Eigen::Vector3d> pointsInPatient;
    std::vector<std::array<std::uint32_t, 3>> triangles;   ///< point indices; all are within range
};

/// Result of checking whether a mesh encloses a volume.
struct MeshCheck {
    std::size_t boundaryEdges = 0;   ///< number of edges with only one triangle, which border a hole
    std::size_t nonManifoldEdges = 0;   ///< number of edges with more than two triangles
    bool isOriented = false;   ///< whether neighboring triangles have consistent orientation

    bool isClosed() const { return boundaryEdges == 0 && nonManifoldEdges == 0; }
};
MeshCheck checkMesh(const SurfaceMesh& mesh);

/// Returns the mesh with coincident points merged and zero-area triangles removed. Incomplete if `shouldContinue`,
/// which is called regularly, returns false.
SurfaceMesh weldPoints(const SurfaceMesh& mesh, const std::function<bool()>& shouldContinue = {});

}   // namespace angiopose::core
