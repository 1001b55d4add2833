#pragma once

#include "core/imaging/image2d.h"
#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

/// The field that the display shutter leaves open (PS3.3 C.7.6.11): 255 inside of all its shapes, their edges included.
/// Empty where the header has none, or it hides nothing. A shape that makes no sense is left out, and a warning says
/// so. Enhanced XA: what the shutters of all frames leave open.
core::Mask2d shutterOf(const DicomDataset& data, int columns, int rows, core::Messages& warnings);

}   // namespace angiopose::io
