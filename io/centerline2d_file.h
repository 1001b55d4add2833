#pragma once

#include "core/support/result.h"
#include "core/vessel/centerline2d.h"

#include <string>

namespace angiopose::io {

/// 2-D centreline from CSV (`x,y,branch,radius`) or a PNG mask (traced).
core::Result<core::Centerline2d> readCenterline2d(const std::string& path);

/// CSV `x,y,branch,radius`, px.
std::string centerline2dText(const core::Centerline2d& centerline);

/// Writes it atomically.
core::Status writeCenterline2d(const core::Centerline2d& centerline, const std::string& path);

}   // namespace angiopose::io