#pragma once

#include "ui/scenes/line_data.h"
#include "ui/scenes/overlay_content.h"

namespace angiopose::ui {

/// Fills `lines` with the branches of the tree in patient space, mm; the topmost branch comes last.
void fillTreeLines(LineData& lines, const OverlayContent& content);

/// Fills `lines` with the branches that glow, in their own colors.
void fillGlowLines(LineData& lines, const OverlayContent& content);

/// Adds the traced curves in camera coordinates, mm, on the plane at depth 1000, where they project onto themselves.
void fillTracedLines(LineData& lines, const core::Centerline2d& traced, const core::ProjectionCamera& camera);

}   // namespace angiopose::ui
