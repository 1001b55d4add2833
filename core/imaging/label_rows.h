#pragma once

#include "core/imaging/volume.h"

#include <vector>

namespace angiopose::core {

/// A label image as it is looked at, in half the memory.
struct LabelRows {
    VoxelMask rows;   ///< 1 + the place of a voxel's label in the list; all from the 255th place on share 255
    std::vector<Eigen::Vector3d> middlesInPatient;   ///< per label: its voxel nearest to the mean of its voxels
};

/// Numbers the labels of an image by their places in `labels`, which holds every label once; others become background.
LabelRows labelRows(const LabelVolume& image, const std::vector<int>& labels);

}   // namespace angiopose::core