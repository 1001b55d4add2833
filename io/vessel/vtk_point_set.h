#pragma once

#include "io/vessel/vtk_lines.h"

#include <optional>

class vtkPointSet;

namespace angiopose::io {

/// Converts VTK PolyData or an UnstructuredGrid; returns nullopt if the cells are damaged.
std::optional<VtkLines> linesOf(vtkPointSet* data);

}   // namespace angiopose::io
