#pragma once

#include "core/geometry/gantry_header.h"
#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Returns the gantry data of an X-ray header that cArmOf does not read (ALGORITHMS §5.1): data for plausibility
/// checks, the angles of each frame relative to the first, and all geometry elements for display. Warns if the gantry
/// moved but the header does not describe its motion.
core::GantryHeader gantryHeaderOf(const DicomDataset& data, int frameCount, core::Messages& warnings);

}   // namespace angiopose::io
