#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/vessel/surface_mesh.h"

#include <functional>

namespace angiopose::core {

/// Returns a voxel size that resolves the mesh with at most about fifty million voxels, about five million of them
/// inside; at least 0.1 mm.
double usualSpacingMm(const SurfaceMesh& mesh);

/// Returns the voxels whose centers lie inside the mesh, on a grid along the patient's axes with a margin. A closed,
/// oriented mesh is filled by winding number, so parts may overlap. Open or tangled meshes are decided by a majority of
/// the three axes, which closes the open ends of tubes. Fails on a mesh without extent, on too fine a spacing, and as
/// canceled when `shouldContinue`, which is called regularly, returns false.
Result<VoxelMask> fillSurface(const SurfaceMesh& mesh, double spacingMm,
                              const std::function<bool()>& shouldContinue = {});

}   // namespace angiopose::core