#include "io/vessel/vtk_lines.h"

#include <vtkCellType.h>
#include <array>
#include <cmath>

namespace angiopose::io {
namespace {

constexpr std::array radiusNames = {"Radius", "MaximumInscribedSphereRadius", "radius"};
constexpr std::array idNames = {"GroupIds", "CenterlineIds", "BranchId", "branch"};

template <std::size_t Count>
const std::vector<double>* findArray(const std::map<std::string, std::vector<double>>& arrays,
                                     const std::array<const char*, Count>& names)
{
    for (const char* name : names) {
        const auto found = arrays.find(name);
        if (found != arrays.end()) {
            return &found->second;
        }
    }
    return nullptr;
}

/// Triangles of strips: every second one is turned round.
void appendStrips(const VtkCells& strips, VtkCells& triangles)
{
    for (const auto& strip : strips) {
        for (std::size_t k = 2; k < strip.size(); ++k) {
            const bool isTurned = k % 2 == 1;
            triangles.push_back({strip[k - 2], strip[isTurned ? k : k - 1], strip[isTurned ? k - 1 : k]});
        }
    }
}

}   // namespace

void addCells(VtkCellSections cells, VtkLines& lines)
{
    // Cell data counts vertices first, then lines (vtkPolyData).
    for (std::size_t i = 0; i < cells.lines.size(); ++i) {
        lines.set.lines.push_back(std::move(cells.lines[i]));
        lines.cellOfLine.push_back(cells.vertexCount + i);
    }
    for (std::size_t i = 0; i < cells.mixed.size() && i < cells.types.size(); ++i) {
        const int type = cells.types[i];
        if (type == VTK_LINE || type == VTK_POLY_LINE) {
            lines.set.lines.push_back(std::move(cells.mixed[i]));
            lines.cellOfLine.push_back(i);
        } else if (type == VTK_TRIANGLE || type == VTK_POLYGON || type == VTK_QUAD) {
            cells.polygons.push_back(std::move(cells.mixed[i]));
        }
        lines.set.hasSurface |= type > VTK_POLY_LINE;
    }
    appendStrips(cells.strips, cells.polygons);
    lines.set.hasSurface |= !cells.polygons.empty();
    lines.polygons = std::move(cells.polygons);
}

LineSet lineSetOf(VtkLines lines)
{
    LineSet set = std::move(lines.set);
    const auto* radius = findArray(lines.pointArrays, radiusNames);
    if (radius && radius->size() == set.points.size()) {
        set.radius = *radius;
    }
    const auto* ids = findArray(lines.cellArrays, idNames);
    for (const std::size_t cell : lines.cellOfLine) {
        if (ids && cell < ids->size() && std::abs((*ids)[cell]) < 1e9) {
            set.ids.push_back(static_cast<int>((*ids)[cell]));
        }
        if (cell < lines.cellNames.size()) {
            set.names.push_back(lines.cellNames[cell]);
        }
    }
    if (set.ids.size() != set.lines.size()) {
        set.ids.clear();
    }
    if (set.names.size() != set.lines.size()) {
        set.names.clear();
    }
    return set;
}

}   // namespace angiopose::io