#pragma once

#include "core/case/case.h"

#include <QString>

#include <utility>
#include <vector>

namespace angiopose::app {

/// What it is, and what it is here.
using ReportRows = std::vector<std::pair<QString, QString>>;

/// What was measured in the image of the shown view: value and basis of each.
ReportRows measuredRows(const core::Case& session);

/// Check points with their errors and what the pose claims, and rings; of the shown view and all together.
ReportRows checkedRows(const core::Case& session);

/// " · ⌀ 3.1 mm, narrowest 1.2 mm (−60 %)", by the tree's radii; nothing without.
QString widthWords(const core::VesselBranch& branch);

}   // namespace angiopose::app
