#pragma once

#include "io/vessel/vtk_lines.h"

#include <optional>
#include <string_view>

namespace angiopose::io {

enum class XmlVtkKind { PolyData, UnstructuredGrid };

/// VTK XML, as VTK reads it. Nothing where VTK complains or an array holds less than the file declares; throws
/// std::bad_alloc where memory does not suffice.
std::optional<VtkLines> parseXmlVtk(std::string_view content, XmlVtkKind kind);

}   // namespace angiopose::io
