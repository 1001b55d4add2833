#pragma once

#include "core/geometry/c_arm.h"
#include "io/dicom/dicom_dataset.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// C-arm geometry of an XA header (ALGORITHMS §5.1, §5.2), each value with its origin. What the header does not give
/// stays missing unless other tags determine it; then it is derived, and a warning says so.
/// Enhanced XA: the functional groups of the first frame.
core::CArm cArmOf(const DicomDataset& data, core::Messages& warnings);

/// The data set with what only its functional groups hold (those of the first frame, then the shared ones) on top.
DicomDataset withFunctionalGroups(const DicomDataset& data);

/// True for the warning of `cArmOf` that the header leaves the pixel spacing out: of no use where it is known
/// otherwise.
bool isAboutMissingSpacing(const core::Message& warning);

}   // namespace angiopose::io