#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Segment of a DICOM segmentation; its segment number is used as the label.
struct DicomSegment {
    int number = 0;
    std::string name;
};

/// Returns whether the SOP class is a segmentation: binary or fractional, or the label map introduced in 2023.
bool isSegmentationClass(std::string_view sopClassUid);

/// Returns whether the file is a DICOM segmentation.
bool isDicomSegmentation(const std::string& path);

/// Lists the segments declared in a segmentation, in file order.
core::Result<std::vector<DicomSegment>> listSegments(const std::string& path);

/// Reads a DICOM segmentation (PS3.3 A.51) as a label image: the label of a voxel is its segment number, or the lowest
/// number if segments overlap. Fractional values count as set if they reach half of the maximum. Frames omitted from
/// the file are empty. Fails if the frames do not lie on a single regular grid or the bits are compressed.
core::Result<core::LabelVolume> readDicomSegmentation(const std::string& path, const ReadObserver& observe = {});

}   // namespace angiopose::io
