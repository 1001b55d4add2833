#pragma once

#include "io/vessel/vtk_lines.h"

#include <optional>

class vtkPointSet;

namespace angiopose::io {

/// Converts VTK poly-data or an unstructured grid; nullopt if its cells are damaged.
std::optional<VtkLines> linesOf(vtkPointSet* data);

}   // namespace angiopose::io
