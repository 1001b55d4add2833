#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// One segment of a DICOM segmentation; its segment number is its label.
struct DicomSegment {
    int number = 0;
    std::string name;
};

/// Returns true for the SOP classes of segmentations: binary or fractional, and the label map of 2023.
bool isSegmentationClass(std::string_view sopClassUid);

/// Returns true for a DICOM file that holds a segmentation.
bool isDicomSegmentation(const std::string& path);

/// Lists the segments that a segmentation names, in file order.
core::Result<std::vector<DicomSegment>> listSegments(const std::string& path);

/// Reads a DICOM segmentation (PS3.3 A.51) as a label image: the label of a voxel is its segment number, or the lowest
/// one if segments overlap. Fractional values count from half of the maximum. Frames omitted because they are empty
/// stay empty. Fails if frames do not lie on one regular grid, or if the bits are compressed.
core::Result<core::LabelVolume> readDicomSegmentation(const std::string& path, const ReadObserver& observe = {});

}   // namespace angiopose::io