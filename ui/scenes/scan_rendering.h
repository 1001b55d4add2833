#pragma once

#include "core/viewing/scan/render_scan.h"

namespace angiopose::ui {

/// Volume rendering of the scan from one viewpoint; bottom row first, premultiplied alpha.
struct ScanRendering {
    core::ParallelProjection projection;
    core::Image2d<core::Rgba> pixels;
};

}   // namespace angiopose::ui
