#pragma once

#include "core/case/case.h"

#include <QString>

#include <utility>
#include <vector>

namespace angiopose::app {

/// Rows of a name and a value each.
using ReportRows = std::vector<std::pair<QString, QString>>;

/// Returns the measurements in the image of the shown view, each with its value and basis.
ReportRows measurementRows(const core::Case& session);

/// Returns the target points with their errors and the stated uncertainty of the pose, and the rings, for the shown
/// view and for all views together.
ReportRows targetPointRows(const core::Case& session);

/// Returns e.g. " · ⌀ 3.1 mm, narrowest 1.2 mm (−60 %)", from the radii of the tree; empty if there are none.
QString diameterText(const core::VesselBranch& branch);

}   // namespace angiopose::app
