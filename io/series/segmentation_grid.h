#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/dicom/dicom_dataset.h"
#include "io/series/slice_record.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// The grid on which the frames of a segmentation lie. Several frames may share a layer; layers without a frame are
/// empty.
struct SegmentationGrid {
    core::VolumeGeometry geometry;
    std::vector<int> layers;   ///< layer index of each frame
};

/// Returns the smallest grid that holds all frames. Fails if frames do not state their positions, or do not lie on a
/// regular grid.
core::Result<SegmentationGrid> segmentationGrid(const std::vector<SliceRecord>& frames, const DicomDataset& data,
                                                const std::string& path);

}   // namespace angiopose::io