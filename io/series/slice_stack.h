#pragma once

#include "core/imaging/volume.h"
#include "io/series/slice_record.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// The source of one layer of the volume: a slice, or an interpolation between two.
struct StackLayer {
    std::size_t lower = 0;   ///< index of a slice
    std::size_t upper = 0;
    double upperWeight = 0.0;   ///< 0: the lower slice unchanged
};

/// A regular grid over slices that may be irregular: gaps are interpolated, uneven spacing is resampled to a fine
/// typical step, and the shear of a tilted gantry is removed by shifting the slices in their planes.
struct SliceStack {
    core::VolumeGeometry geometry;
    std::vector<StackLayer> layers;   ///< one per k
    std::vector<Eigen::Vector2d> shiftVoxels;   ///< per slice: position of its first pixel in the layer (i, j)
    core::Messages warnings;
    std::optional<core::Message> problem;   ///< reason why there is no volume, with the remedy
};

/// Plans the volume of slices that share size, spacing and orientation, sorted along the normal of their planes, each
/// at a different position.
SliceStack stackOf(const std::vector<SliceRecord>& slices);

/// Returns the unit normal of a slice's plane; slices are stacked along it.
Eigen::Vector3d normalOf(const SliceRecord& slice);

}   // namespace angiopose::io