#pragma once

#include "io/vessel/vtk_lines.h"

#include <string>
#include <string_view>

namespace angiopose::io {

// Parsers that never allocate more than the rest of the file can contain. Indices are checked later.
core::Result<VtkLines> parseStl(std::string_view content, const std::string& path);
core::Result<VtkLines> parseObj(std::string_view content, const std::string& path);

/// Whether the content is binary STL, whose length follows from the declared number of triangles.
bool looksLikeBinaryStl(std::string_view content);

}   // namespace angiopose::io
