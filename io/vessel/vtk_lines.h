#pragma once

#include "io/vessel/line_set.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Point indices; an index out of range stays out of range.
using Triangle = std::array<std::uint32_t, 3>;

/// Splits a polygon into triangles that share its first corner.
void addFan(const std::vector<std::size_t>& corners, std::vector<Triangle>& triangles);

/// The lines of a VTK file, before radius and ids are picked from its arrays.
struct VtkLines {
    LineSet set;
    std::vector<std::size_t> cellOfLine;   ///< index of each line among all cells
    std::map<std::string, std::vector<double>> pointArrays;   ///< one-component arrays by name
    std::map<std::string, std::vector<double>> cellArrays;
    std::vector<std::string> cellNames;   ///< names of all cells, or empty
    std::string header;   ///< textual field data, one "name = words" per line
    std::vector<Triangle> triangles;   ///< from triangles, quads, polygons and strips: a surface
};

/// Picks the arrays of radius (`Radius`, `MaximumInscribedSphereRadius`) and ids (`GroupIds`, `CenterlineIds`,
/// `branch`).
LineSet lineSetOf(VtkLines lines);

}   // namespace angiopose::io
