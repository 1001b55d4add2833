#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/vessel/surface_mesh.h"

#include <functional>

namespace angiopose::core {

/// A voxel size that resolves the mesh within some fifty million voxels, some five of them inside, never below 0.1 mm.
double usualSpacingMm(const SurfaceMesh& mesh);

/// Voxels whose centre lies inside the mesh, on a grid along the patient's axes with room around. A closed, oriented
/// mesh is filled by winding number, so that parts may overlap. Open or tangled meshes are decided by the majority of
/// the three axes, which closes the open ends of tubes. Fails on a mesh without extent, or too fine a spacing, and as
/// stopped where `shouldContinue`, asked all the time, says no.
Result<VoxelMask> fillSurface(const SurfaceMesh& mesh, double spacingMm,
                              const std::function<bool()>& shouldContinue = {});

}   // namespace angiopose::core