#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/vessel/surface_mesh.h"

#include <functional>

namespace angiopose::core {

/// Returns a voxel size of at least 0.1 mm for which the mesh's bounding box has at most about fifty million voxels and
/// about five million of these lie inside the mesh.
double defaultSpacingMm(const SurfaceMesh& mesh);

/// Returns the voxels whose centers lie inside the mesh, on a grid along the patient's axes with a margin. A closed,
/// oriented mesh is filled by winding number, so its parts may overlap. For open or inconsistently oriented meshes, a
/// majority vote of the three axes decides, which closes the open ends of tubes. Fails for a mesh without extent or too
/// fine a spacing; canceled if `shouldContinue`, which is called regularly, returns false.
Result<VoxelMask> fillSurface(const SurfaceMesh& mesh, double spacingMm,
                              const std::function<bool()>& shouldContinue = {});

}   // namespace angiopose::core
