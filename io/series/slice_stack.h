#pragma once

#include "core/imaging/volume.h"
#include "io/series/slice_record.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// How one layer of the volume is made: from a slice, or between two of them.
struct StackLayer {
    std::size_t lower = 0;   ///< index of a slice
    std::size_t upper = 0;
    double upperWeight = 0.0;   ///< 0: the lower slice as it is
};

/// A regular grid over slices that need not be regular: gaps are filled between neighbours, uneven spacing is resampled
/// to the finest usual step, and the slant of a tilted gantry is shifted out within the slices.
struct SliceStack {
    core::VolumeGeometry geometry;
    std::vector<StackLayer> layers;   ///< one per k
    std::vector<Eigen::Vector2d> shiftVoxels;   ///< per slice: where its first pixel lies in the layer (i, j)
    core::Messages warnings;
    std::optional<core::Message> problem;   ///< why there is no volume, with the remedy
};

/// Plans the volume of slices that share size, spacing and orientation, ordered along the normal of their planes, each
/// at a place of its own.
SliceStack stackOf(const std::vector<SliceRecord>& slices);

/// Unit normal of a slice's plane; slices are stacked along it.
Eigen::Vector3d normalOf(const SliceRecord& slice);

}   // namespace angiopose::io