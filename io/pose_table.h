#pragma once

#include "core/support/result.h"
#include "core/workflow/follow_frames.h"

#include <span>
#include <string>

namespace angiopose::io {

/// CSV of one pose per frame: frame, trustworthy (1 or 0), searched, score, and cameraFromPatient as r11 … r33, tx, ty,
/// tz (mm), row by row, with enough digits to restore the same doubles; then how far the vessels are bent beside that
/// pose, on average and at most (mm), nothing where they are not. Written atomically.
core::Status writePoseTable(std::span<const core::FollowedFrame> frames, const std::string& path);

}   // namespace angiopose::io