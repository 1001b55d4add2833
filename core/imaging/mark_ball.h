#pragma once

#include "core/imaging/volume.h"

namespace angiopose::core {

/// Marks the voxels whose centers lie within `radiusMm` of a point.
void markBall(const Eigen::Vector3d& pointInPatient, double radiusMm, VoxelMask& mask);

}   // namespace angiopose::core
