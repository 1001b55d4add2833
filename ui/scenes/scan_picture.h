#pragma once

#include "core/viewing/scan/cast_scan.h"

namespace angiopose::ui {

/// Volume rendering of the scan from one viewpoint; bottom row first, premultiplied alpha.
struct ScanPicture {
    core::ParallelSight sight;
    core::Image2d<core::Rgba> pixels;
};

}   // namespace angiopose::ui
