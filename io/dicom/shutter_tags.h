#pragma once

#include "core/imaging/image2d.h"
#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

/// The field left open by the display shutter (PS3.3 C.7.6.11): 255 inside all of its shapes, including their edges.
/// Empty if the header has no shutter or it hides nothing. Skips an invalid shape with a warning. Enhanced XA: the
/// union of the open fields of all frames.
core::Mask2d shutterOf(const DicomDataset& data, int columns, int rows, core::Messages& warnings);

}   // namespace angiopose::io
