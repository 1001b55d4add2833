#pragma once

#include "core/case/case.h"
#include "io/dicom/objects/measurement_report.h"

#include <vector>

namespace angiopose::io {

/// Returns the groups of a report: measurements in the shown view and in slices of the scan, and the fit of the view's
/// registration. Omits entries without a value.
std::vector<ReportGroup> reportGroups(const core::Case& session);

}   // namespace angiopose::io
