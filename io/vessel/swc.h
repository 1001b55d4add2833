#pragma once

#include "io/vessel/line_set.h"

#include <string_view>

namespace io {

/// SWC rows `id type x y z radius parent` as segments between points; lengths times `unitMm`.
core::Result<LineSet> parseSwc(std::string_view text, double unitMm, const std::string& path);

}   // namespace io
