#pragma once

#include "io/vessel/vtk_lines.h"

#include <cstddef>
#include <vector>

namespace angiopose::io {

/// Point ids of each cell.
using VtkCells = std::vector<std::vector<std::size_t>>;

/// Appends the cell whose point ids are `values[first]` to `values[end - 1]`; false on a negative id.
bool appendCell(const std::vector<double>& values, std::size_t first, std::size_t end, VtkCells& cells);

/// The cells of one legacy file, as its sections give them.
struct LegacyVtkCells {
    VtkCells vertices, lines, polygons, strips;
    VtkCells mixed;   ///< of an unstructured grid
    std::vector<double> types;   ///< of those
};

/// Puts poly-lines (with the cell that each is) and polygons into `lines`.
void addCells(LegacyVtkCells cells, VtkLines& lines);

}   // namespace angiopose::io