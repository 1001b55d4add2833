#pragma once

#include "io/vessel/vtk_lines.h"

#include <optional>

class vtkPointSet;

namespace angiopose::io {

/// What VTK read, poly-data or an unstructured grid, as ours; nothing when its cells are damaged.
std::optional<VtkLines> linesOf(vtkPointSet* data);

}   // namespace angiopose::io
