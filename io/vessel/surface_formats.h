#pragma once

#include "io/vessel/vtk_lines.h"

#include <string>
#include <string_view>

namespace angiopose::io {

// Own parsers: none allocates for a count that the rest of the file cannot hold. Indices are checked later.
core::Result<VtkLines> parseStl(std::string_view content, const std::string& path);
core::Result<VtkLines> parseObj(std::string_view content, const std::string& path);

/// True for a binary STL file: its length follows from the number of triangles it declares.
bool looksLikeBinaryStl(std::string_view content);

}   // namespace angiopose::io
