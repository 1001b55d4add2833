#pragma once

#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

#include <optional>

namespace angiopose::io {

/// Time between frames, as stated in the header.
struct FrameTime {
    double ms = 0.0;   ///< frame interval, ms; 0 if unknown
    std::optional<core::Message> contradiction;   ///< message about a different value elsewhere in the header
};

/// Reads the frame time from the element named by Frame Increment Pointer; otherwise from Frame Time, the median of
/// Frame Time Vector, or from the acquisition frame rate or the recommended display frame rate.
FrameTime frameTimeOf(const DicomDataset& data);

}   // namespace angiopose::io
