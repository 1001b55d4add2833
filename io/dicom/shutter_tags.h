#pragma once

#include "core/imaging/image2d.h"
#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

/// Returns the mask of the area that the display shutter leaves open (PS3.3 C.7.6.11): 255 inside all shapes, including
/// their edges; empty if the header has no shutter or the shutter hides nothing. Skips an invalid shape with a warning.
/// For Enhanced XA, returns the union of the open areas of all frames.
core::Mask2d shutterMask(const DicomDataset& data, int columns, int rows, core::Messages& warnings);

}   // namespace angiopose::io
