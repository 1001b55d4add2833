#pragma once

#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

/// The functional groups of a DICOM object of many frames: what holds for all of them, and one item for each frame.
inline constexpr DicomTag sharedGroupsTag = 0x52009229;
inline constexpr DicomTag perFrameGroupsTag = 0x52009230;

}   // namespace angiopose::io
