#pragma once

#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

#include <optional>

namespace angiopose::io {

/// The time from frame to frame.
struct FrameTime {
    double ms = 0.0;   ///< 0: not known
    std::optional<core::Message> contradiction;   ///< what else the header says
};

/// From where the Frame Increment Pointer leads, else from Frame Time, the median of Frame Time Vector, or the rate at
/// which the run was taken or is to be shown.
FrameTime frameTimeOf(const DicomDataset& data);

}   // namespace angiopose::io
