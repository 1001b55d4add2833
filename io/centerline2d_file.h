#pragma once

#include "core/support/result.h"
#include "core/vessel/centerline2d.h"

#include <string>

namespace angiopose::io {

/// Reads a 2-D centerline from CSV (`x,y,branch,radius`), or traces one in a PNG mask.
core::Result<core::Centerline2d> readCenterline2d(const std::string& path);

/// Returns the centerline as CSV `x,y,branch,radius`, px.
std::string centerline2dText(const core::Centerline2d& centerline);

/// Atomically writes a 2-D centerline as CSV (`x,y,branch,radius`, px).
core::Status writeCenterline2d(const core::Centerline2d& centerline, const std::string& path);

}   // namespace angiopose::io
