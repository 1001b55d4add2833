#pragma once

#include "io/vessel/vtk_lines.h"

#include <string>
#include <string_view>

namespace angiopose::io {

// Parse surface files. None allocates more memory than the rest of the file can fill; indices are checked later.
core::Result<VtkLines> parseStl(std::string_view content, const std::string& path);
core::Result<VtkLines> parseObj(std::string_view content, const std::string& path);

/// Returns whether the content is binary STL, whose length follows from the declared number of triangles.
bool looksLikeBinaryStl(std::string_view content);

}   // namespace angiopose::io
