#pragma once

#include "io/raster/read_raster.h"

#include <optional>
#include <string_view>

namespace angiopose::io {

/// A grey or colour JPEG; nothing when it is too large, of another kind, or the decoder has the slightest complaint.
std::optional<Raster> readJpeg(std::string_view content);

}   // namespace angiopose::io