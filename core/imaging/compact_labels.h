#pragma once

#include "core/imaging/volume.h"

#include <vector>

namespace angiopose::core {

/// A label image for display in 8 bit, which halves the memory.
struct CompactLabels {
    VoxelMask rows;   ///< 1 + index of the voxel's label in the list; all labels from the 255th on share the value 255
    std::vector<Eigen::Vector3d> centersInPatient;   ///< per label, the voxel nearest to the centroid of its voxels
};

/// Replaces the labels of an image by their position in `labels`, which must contain each label once; other labels
/// become background.
CompactLabels compactLabels(const LabelVolume& image, const std::vector<int>& labels);

}   // namespace angiopose::core
