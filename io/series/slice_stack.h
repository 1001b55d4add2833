#pragma once

#include "core/imaging/volume.h"
#include "io/series/slice_record.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Source of one layer of the volume: a slice, or the interpolation between two slices.
struct StackLayer {
    std::size_t lower = 0;   ///< index of the slice at or below the layer
    std::size_t upper = 0;
    double upperWeight = 0.0;   ///< 0 if the layer equals the lower slice
};

/// Regular grid for slices that may be irregular: gaps are interpolated, unevenly spaced slices are resampled to a
/// fine, typical spacing, and the shear caused by a tilted gantry is removed by shifting the slices in-plane.
struct SliceStack {
    core::VolumeGeometry geometry;
    std::vector<StackLayer> layers;   ///< one layer per index k
    std::vector<Eigen::Vector2d> shiftVoxels;   ///< position (i, j) of the first pixel of each slice in its layer
    core::Messages warnings;
    std::optional<core::Message> problem;   ///< reason why the slices form no volume, with the remedy
};

/// Plans the volume for slices that share size, spacing and orientation, have distinct positions, and are sorted along
/// the slice normal.
SliceStack planStack(const std::vector<SliceRecord>& slices);

/// Returns the unit normal of a slice, along which slices are stacked.
Eigen::Vector3d normalOf(const SliceRecord& slice);

}   // namespace angiopose::io
