#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace angiopose::core {

/// The vessel wall as triangles, patient LPS mm.
struct SurfaceMesh {
    std::vector<Eigen::Vector3d> pointsInPatient;
    std::vector<std::array<std::uint32_t, 3>> triangles;   ///< indices into the points; all within range
};

/// Result of checking how well a mesh encloses a volume.
struct MeshCheck {
    std::size_t openEdges = 0;   ///< edges with one triangle, on the border of a hole
    std::size_t crowdedEdges = 0;   ///< edges with more than two triangles
    bool isOriented = false;   ///< whether neighboring triangles agree on the outside

    bool isClosed() const { return openEdges == 0 && crowdedEdges == 0; }
};
MeshCheck checkMesh(const SurfaceMesh& mesh);

/// Returns the mesh with coincident points merged and triangles without area removed. Incomplete if `shouldContinue`,
/// called from time to time, returns false.
SurfaceMesh welded(const SurfaceMesh& mesh, const std::function<bool()>& shouldContinue = {});

}   // namespace angiopose::core