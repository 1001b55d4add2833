#include "io/vessel/legacy_vtk_cells.h"

#include <utility>

namespace angiopose::io {
namespace {

constexpr int vtkLineType = 3;
constexpr int vtkPolyLineType = 4;
constexpr int vtkTriangleType = 5;
constexpr int vtkPolygonType = 7;
constexpr int vtkQuadType = 9;

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

bool appendCell(const std::vector<double>& values, std::size_t first, std::size_t end, VtkCells& cells)
{
    std::vector<std::size_t> cell;
    for (std::size_t k = first; k < end; ++k) {
        if (!(values[k] >= 0.0) || values[k] > 1e12) {
            return false;
        }
        cell.push_back(static_cast<std::size_t>(values[k]));
    }
    cells.push_back(std::move(cell));
    return true;
}

void addCells(LegacyVtkCells cells, VtkLines& lines)
{
    // Cell data counts vertices first, then lines (vtkPolyData).
    for (std::size_t i = 0; i < cells.lines.size(); ++i) {
        lines.set.lines.push_back(std::move(cells.lines[i]));
        lines.cellOfLine.push_back(cells.vertices.size() + i);
    }
    for (std::size_t i = 0; i < cells.mixed.size() && i < cells.types.size(); ++i) {
        const auto type = static_cast<int>(cells.types[i]);
        if (type == vtkLineType || type == vtkPolyLineType) {
            lines.set.lines.push_back(std::move(cells.mixed[i]));
            lines.cellOfLine.push_back(i);
        } else {
            lines.set.hasSurface |= type > vtkPolyLineType;
            if (type == vtkTriangleType || type == vtkPolygonType || type == vtkQuadType) {
                cells.polygons.push_back(std::move(cells.mixed[i]));
            }
        }
    }
    appendStrips(cells.strips, cells.polygons);
    lines.set.hasSurface |= !cells.polygons.empty();
    lines.polygons = std::move(cells.polygons);
}

}   // namespace angiopose::io