#pragma once

#include "core/viewing/scan/cast_scan.h"

namespace angiopose::ui {

/// The scan as it was seen from somewhere: the lowest row first, colours multiplied by their opacity.
struct ScanPicture {
    core::ParallelSight sight;
    core::Image2d<core::Rgba> pixels;
};

}   // namespace angiopose::ui
