#pragma once

#include "core/measuring/target_points.h"
#include "ui/panels/mark_panel.h"

#include <QString>

namespace angiopose::app {

/// Row of a target point or ring for the list next to the shown view.
ui::MarkRow markRow(const core::VesselMark& mark, const std::vector<core::CheckedPoint>& checked,
                    std::size_t shownView);
ui::MarkRow annotationRow(const core::ImageAnnotation& annotation);

/// Everything known about a target point, one sentence per fact.
QString checkedSentences(const core::CheckedPoint& checked, std::size_t viewCount);

/// "Target point 3", "Ostium 1": the first name that no mark has.
QString freeMarkName(core::VesselMarkKind kind, const std::vector<core::VesselMark>& marks);

}   // namespace angiopose::app
