#pragma once

#include "core/geometry/c_arm.h"
#include "io/dicom/dicom_dataset.h"

#include <string>
#include <vector>

namespace io {

/// C-arm geometry of an XA header (ALGORITHMS §5.1, §5.2), each value with its origin. What the header does not give
/// stays missing unless other tags determine it; then it is derived, and a warning says so.
/// Enhanced XA: the functional groups of the first frame.
core::CArm cArmOf(const DicomDataset& data, std::vector<std::string>& warnings);

}   // namespace io
