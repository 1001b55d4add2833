#pragma once

#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

#include <optional>

namespace angiopose::io {

/// The time between frames.
struct FrameTime {
    double ms = 0.0;   ///< 0: unknown
    std::optional<core::Message> contradiction;   ///< a different value elsewhere in the header
};

/// Reads the frame time from the element that the Frame Increment Pointer names, otherwise from Frame Time, the median
/// of Frame Time Vector, or the acquisition or recommended display rate.
FrameTime frameTimeOf(const DicomDataset& data);

}   // namespace angiopose::io
