#pragma once

#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

/// Functional group sequences of a multi-frame DICOM object: shared by all frames, and with one item per frame.
inline constexpr DicomTag sharedGroupsTag = 0x52009229;
inline constexpr DicomTag perFrameGroupsTag = 0x52009230;

}   // namespace angiopose::io
