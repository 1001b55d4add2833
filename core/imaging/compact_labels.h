#pragma once

#include "core/imaging/volume.h"

#include <vector>

namespace angiopose::core {

/// A label image for display that needs half the memory (8 bit).
struct CompactLabels {
    VoxelMask rows;   ///< 1 + index of the voxel's label in the list; the 255th and later labels share 255
    std::vector<Eigen::Vector3d> centersInPatient;   ///< per label: the voxel nearest to the mean of its voxels
};

/// Replaces the labels of an image with their position in `labels`, which contains every label once; other labels
/// become background.
CompactLabels compactLabels(const LabelVolume& image, const std::vector<int>& labels);

}   // namespace angiopose::core
