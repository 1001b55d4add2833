#pragma once

#include "core/case/case.h"
#include "io/dicom/objects/measurement_report.h"

#include <vector>

namespace angiopose::io {

/// What was measured in the shown view and in slices of the scan, and how well the view's registration fits, ready for
/// a report. What has no value is left out.
std::vector<ReportedGroup> reportedGroups(const core::Case& session);

}   // namespace angiopose::io
