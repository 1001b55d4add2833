#pragma once

#include "ui/scenes/line_data.h"
#include "ui/scenes/overlay_content.h"

namespace angiopose::ui {

/// The tree's branches in patient space, mm, those drawn last at the end.
void fillTreeLines(LineData& lines, const OverlayContent& content);

/// Those that glow, in their own tones.
void fillGlowLines(LineData& lines, const OverlayContent& content);

/// The traced curves in the camera's frame, mm, on the plane at depth 1000: they project onto themselves.
void fillTracedLines(LineData& lines, const core::Centerline2d& traced, const core::ProjectionCamera& camera);

}   // namespace angiopose::ui
