#pragma once

#include "core/geometry/c_arm.h"
#include "io/dicom/dicom_dataset.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// C-arm geometry of an XA header (ALGORITHMS §5.1, §5.2), each value with its origin. A missing value stays missing
/// unless other tags determine it; a derived value comes with a warning. Enhanced XA: uses the functional groups of the
/// first frame.
core::CArm cArmOf(const DicomDataset& data, core::Messages& warnings);

/// Returns the data set with the elements of its functional groups (those of the first frame, then the shared ones)
/// added at the top level.
DicomDataset withFunctionalGroups(const DicomDataset& data);

/// True for the warning of `cArmOf` about missing pixel spacing, which is irrelevant if the spacing is known from
/// another source.
bool isAboutMissingSpacing(const core::Message& warning);

}   // namespace angiopose::io