#pragma once

#include "core/measuring/target_points.h"
#include "ui/panels/mark_panel.h"

#include <QString>

namespace angiopose::app {

/// Returns the list row of a target point or ring for the shown view.
ui::MarkRow markRow(const core::VesselMark& mark, const std::vector<core::TargetPointResult>& checked,
                    std::size_t shownView);
ui::MarkRow annotationRow(const core::ImageAnnotation& annotation);

/// Describes everything known about a target point, one sentence per fact.
QString targetPointSentences(const core::TargetPointResult& checked, std::size_t viewCount);

/// Returns the first unused name of the form "Target point 3" or "Ostium 1".
QString unusedMarkName(core::VesselMarkKind kind, const std::vector<core::VesselMark>& marks);

}   // namespace angiopose::app
