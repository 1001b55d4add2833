#pragma once

#include "core/geometry/gantry_header.h"
#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Gantry data of an X-ray header in addition to the values of cArmOf (ALGORITHMS §5.1): data for checking them, angles
/// of each frame relative to the first, and all geometry elements for display. Warns if the gantry moved and the header
/// does not give the motion.
core::GantryHeader gantryHeaderOf(const DicomDataset& data, int frameCount, core::Messages& warnings);

}   // namespace angiopose::io