#pragma once

#include "io/vessel/line_set.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Indices of points; beyond all of them where the file's own is.
using Triangle = std::array<std::uint32_t, 3>;

/// Cuts a polygon into triangles that share its first corner.
void addFan(const std::vector<std::size_t>& corners, std::vector<Triangle>& triangles);

/// What a VTK file says about lines, before radius and ids are picked from its arrays.
struct VtkLines {
    LineSet set;
    std::vector<std::size_t> cellOfLine;   ///< index of each line among all cells
    std::map<std::string, std::vector<double>> pointArrays;   ///< one-component arrays by name
    std::map<std::string, std::vector<double>> cellArrays;
    std::vector<std::string> cellNames;   ///< of all cells, or empty
    std::string header;   ///< field data that say something in words, "name = words", a line each
    std::vector<Triangle> triangles;   ///< of triangles, quads, polygons and strips: a surface
};

/// Picks radius and ids: `Radius`, `MaximumInscribedSphereRadius`; `GroupIds`, `CenterlineIds`, `branch`.
LineSet lineSetOf(VtkLines lines);

}   // namespace angiopose::io
