#pragma once

#include "core/geometry/c_arm.h"
#include "io/dicom/dicom_dataset.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Returns the C-arm geometry of an XA header (ALGORITHMS §5.1, §5.2), each value with its origin. A value without a
/// tag of its own is derived from other tags, with a warning, or remains missing. For enhanced XA, uses the functional
/// groups of the first frame.
core::CArm cArmOf(const DicomDataset& data, core::Messages& warnings);

/// Returns the data set with the elements of its functional groups copied to the top level: those of the first frame,
/// then the shared ones.
DicomDataset withFunctionalGroups(const DicomDataset& data);

/// Returns whether a message is the warning of `cArmOf` about missing pixel spacing, which is irrelevant if the spacing
/// is known from another source.
bool isMissingSpacingWarning(const core::Message& warning);

}   // namespace angiopose::io
