#pragma once

#include "io/vessel/line_set.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// What a VTK file says about lines, before radius and ids are picked from its arrays.
struct VtkLines {
    LineSet set;
    std::vector<std::size_t> cellOfLine;   ///< index of each line among all cells
    std::map<std::string, std::vector<double>> pointArrays;   ///< one-component arrays by name
    std::map<std::string, std::vector<double>> cellArrays;
    std::vector<std::string> cellNames;   ///< of all cells, or empty
    std::vector<std::vector<std::size_t>> polygons;   ///< triangles, quads and polygons: a surface
};

/// Point ids of each cell.
using VtkCells = std::vector<std::vector<std::size_t>>;

/// The cells of one file, as its sections give them.
struct VtkCellSections {
    std::size_t vertexCount = 0;
    VtkCells lines, polygons, strips;
    VtkCells mixed;   ///< of an unstructured grid
    std::vector<int> types;   ///< of those
};

/// Puts poly-lines (with the cell that each is) and polygons into `lines`.
void addCells(VtkCellSections cells, VtkLines& lines);

/// Legacy VTK (ASCII or binary, format 1 to 5.1), poly-data or unstructured grid. Own parser: it checks every declared
/// count against the file's size before it trusts it.
core::Result<VtkLines> parseLegacyVtk(std::string_view content, const std::string& path);

/// VTK XML: PolyData (.vtp) or UnstructuredGrid (.vtu).
core::Result<VtkLines> parseXmlVtk(std::string_view content, const std::string& path);

/// Picks radius and ids: `Radius`, `MaximumInscribedSphereRadius`; `GroupIds`, `CenterlineIds`, `branch`.
LineSet lineSetOf(VtkLines lines);

}   // namespace angiopose::io