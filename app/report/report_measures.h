#pragma once

#include "core/case/case.h"

#include <QString>

#include <utility>
#include <vector>

namespace angiopose::app {

/// Rows of name and value.
using ReportRows = std::vector<std::pair<QString, QString>>;

/// Measurements in the image of the shown view, each with value and basis.
ReportRows measuredRows(const core::Case& session);

/// Target points, with their errors and the pose's claimed uncertainty, and rings; for the shown view and all views
/// together.
ReportRows checkedRows(const core::Case& session);

/// " · ⌀ 3.1 mm, narrowest 1.2 mm (−60 %)", from the tree's radii; empty without radii.
QString widthWords(const core::VesselBranch& branch);

}   // namespace angiopose::app
