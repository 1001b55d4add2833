#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// One segment of a DICOM segmentation; its number is its label.
struct DicomSegment {
    int number = 0;
    std::string name;
};

/// SOP classes of segmentations: binary or fractional, and the label map of 2023.
bool isSegmentationClass(std::string_view sopClassUid);

/// True for a DICOM file that holds a segmentation.
bool isDicomSegmentation(const std::string& path);

/// The segments a segmentation names, in its order.
core::Result<std::vector<DicomSegment>> listSegments(const std::string& path);

/// A DICOM segmentation (PS3.3 A.51) as a label image: the label of a voxel is its segment's number, of overlapping
/// segments the lower. Fractional values count from half of the largest on. Frames that were left out because they are
/// empty are empty. Fails when frames do not lie on one regular grid, or are compressed bits.
core::Result<core::LabelVolume> readDicomSegmentation(const std::string& path, const ReadObserver& observe = {});

}   // namespace angiopose::io