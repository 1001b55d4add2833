#pragma once

#include "core/geometry/gantry_header.h"
#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// What an X-ray header says about the gantry beside the values of cArmOf (ALGORITHMS §5.1): facts to check them
/// against, the angles of each frame relative to the first, and every geometry element for people to read. Warns where
/// the gantry moved and the header does not say how.
core::GantryHeader gantryHeaderOf(const DicomDataset& data, int frameCount, core::Messages& warnings);

}   // namespace angiopose::io