#pragma once

#include "io/vessel/line_set.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Triangle of point indices as stored in the file, which may be out of range.
using Triangle = std::array<std::uint32_t, 3>;

/// Splits a polygon into triangles that share its first corner.
void addTriangleFan(const std::vector<std::size_t>& corners, std::vector<Triangle>& triangles);

/// Lines of a VTK file, before radii and IDs are selected from its arrays.
struct VtkLines {
    LineSet set;
    std::vector<std::size_t> cellOfLine;   ///< index of each line among all cells
    std::map<std::string, std::vector<double>> pointArrays;   ///< single-component arrays by name
    std::map<std::string, std::vector<double>> cellArrays;
    std::vector<std::string> cellNames;   ///< one name per cell, or empty
    std::string header;   ///< text of the field data, one "name = value" per line
    std::vector<Triangle> triangles;   ///< surface triangles, from triangles, quads, polygons and strips
};

/// Selects the arrays that contain the radius (`Radius`, `MaximumInscribedSphereRadius`) and the IDs (`GroupIds`,
/// `CenterlineIds`, `branch`).
LineSet lineSetOf(VtkLines lines);

}   // namespace angiopose::io
