#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace angiopose::core {

/// The wall of vessels as triangles, patient LPS mm.
struct SurfaceMesh {
    std::vector<Eigen::Vector3d> pointsInPatient;
    std::vector<std::array<std::uint32_t, 3>> triangles;   ///< indices into the points; all within range
};

/// How well a mesh bounds an inside.
struct MeshCheck {
    std::size_t openEdges = 0;   ///< edges with one triangle: the rim of a hole
    std::size_t crowdedEdges = 0;   ///< edges with more than two triangles
    bool isOriented = false;   ///< neighbours agree on which side is outside

    bool isClosed() const { return openEdges == 0 && crowdedEdges == 0; }
};
MeshCheck checkMesh(const SurfaceMesh& mesh);

/// The same mesh with points at exactly the same place merged, and triangles without area left out. Incomplete where
/// `shouldContinue`, asked now and then, says no.
SurfaceMesh welded(const SurfaceMesh& mesh, const std::function<bool()>& shouldContinue = {});

}   // namespace angiopose::core