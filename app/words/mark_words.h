#pragma once

#include "core/measuring/check_points.h"
#include "ui/panels/mark_panel.h"

#include <QString>

namespace angiopose::app {

/// Check point or ring as the window lists it, beside the view that is shown.
ui::MarkRow markRow(const core::VesselMark& mark, const std::vector<core::CheckedPoint>& checked,
                    std::size_t shownView);
ui::MarkRow annotationRow(const core::ImageAnnotation& annotation);

/// All that is known of a check point, a sentence each.
QString checkedSentences(const core::CheckedPoint& checked, std::size_t viewCount);

/// "Check point 3", "Ostium 1": one that none of the marks has.
QString freeMarkName(core::VesselMarkKind kind, const std::vector<core::VesselMark>& marks);

}   // namespace angiopose::app
