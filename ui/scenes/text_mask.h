#pragma once

#include "core/imaging/image2d.h"

#include <string>
#include <vector>

namespace angiopose::ui {

enum class TextAlign { Left, Right };

/// Returns the coverage (0…255) of lines of UTF-8 text in the UI font; empty if there is no text or no font.
core::Mask2d textMask(const std::vector<std::string>& lines, int sizePx, TextAlign align);

}   // namespace angiopose::ui
