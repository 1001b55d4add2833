#include "io/vessel/vtk_point_set.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>

namespace angiopose::io {
namespace {

using PointIds = std::vector<std::size_t>;

/// Returns whether the offsets of a cell array are consistent, which VTK's readers do not check.
bool hasSoundOffsets(vtkCellArray* array)
{
    vtkDataArray* offsets = array->GetOffsetsArray();
    const auto end = static_cast<double>(array->GetConnectivityArray()->GetNumberOfTuples());
    double last = 0.0;
    for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i) {
        const double offset = offsets->GetComponent(i, 0);
        if (offset < last || offset > end) {
            return false;
        }
        last = offset;
    }
    return true;
}

/// Calls `use` with the point IDs of each cell; returns false if the cells are damaged.
template <class Use>
bool eachCell(vtkCellArray* array, const Use& use)
{
    if (array && !hasSoundOffsets(array)) {
        return false;
    }
    const vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; array && i < array->GetNumberOfCells(); ++i) {
        array->GetCellAtId(i, ids);
        use(PointIds(ids->begin(), ids->end()));   // a negative ID becomes an invalid index, detected later
    }
    return true;
}

void addLine(PointIds ids, std::size_t cell, VtkLines& lines)
{
    lines.set.lines.push_back(std::move(ids));
    lines.cellOfLine.push_back(cell);
}

/// Adds the triangles of a strip; reverses every second one, so that all have the same orientation.
void addTriangleStrip(const PointIds& ids, VtkLines& lines)
{
    lines.set.hasSurface = true;
    for (std::size_t k = 2; k < ids.size(); ++k) {
        const bool isTurned = k % 2 == 1;
        addTriangleFan({ids[k - 2], ids[isTurned ? k : k - 1], ids[isTurned ? k - 1 : k]}, lines.triangles);
    }
}

void addPolygon(const PointIds& ids, VtkLines& lines)
{
    lines.set.hasSurface = true;
    addTriangleFan(ids, lines.triangles);
}

bool addCells(vtkPolyData* data, VtkLines& lines)
{
    // In cell data, the vertices come first, then the lines.
    auto cell = static_cast<std::size_t>(data->GetNumberOfVerts());
    return eachCell(data->GetLines(), [&](PointIds ids) { addLine(std::move(ids), cell++, lines); }) &&
           eachCell(data->GetPolys(), [&](const PointIds& ids) { addPolygon(ids, lines); }) &&
           eachCell(data->GetStrips(), [&](const PointIds& ids) { addTriangleStrip(ids, lines); });
}

bool addCells(vtkUnstructuredGrid* grid, VtkLines& lines)
{
    vtkUnsignedCharArray* types = grid->GetCellTypesArray();
    const vtkIdType typeCount = types ? types->GetNumberOfValues() : 0;
    if (typeCount != grid->GetNumberOfCells()) {
        return false;
    }
    vtkIdType cell = 0;
    return eachCell(grid->GetCells(), [&](PointIds ids) {
        const int type = types->GetValue(cell);
        lines.set.hasSurface |= type > VTK_POLY_LINE;
        if (type == VTK_LINE || type == VTK_POLY_LINE) {
            addLine(std::move(ids), static_cast<std::size_t>(cell), lines);
        } else if (type == VTK_TRIANGLE || type == VTK_POLYGON || type == VTK_QUAD) {
            addPolygon(ids, lines);
        }
        ++cell;
    });
}

std::map<std::string, std::vector<double>> scalarArrays(vtkFieldData* data)
{
    std::map<std::string, std::vector<double>> arrays;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
        vtkDataArray* array = data->GetArray(i);
        if (!array || !array->GetName() || array->GetNumberOfComponents() != 1) {
            continue;
        }
        std::vector<double>& values = arrays[array->GetName()];
        for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k) {
            values.push_back(array->GetComponent(k, 0));
        }
    }
    return arrays;
}

/// Returns the text of the field data, in which Slicer stores the axes and other programs the unit.
std::string headerIn(vtkFieldData* data)
{
    constexpr std::size_t longest = 80;
    std::string header;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
        vtkAbstractArray* array = data->GetAbstractArray(i);
        if (array && array->GetName() && array->GetNumberOfValues() > 0 && header.size() < 50 * longest) {
            header += std::string(array->GetName()).substr(0, longest) + " = " +
                      std::string(array->GetVariantValue(0).ToString()).substr(0, longest) + "\n";
        }
    }
    return header;
}

}   // namespace

std::optional<VtkLines> linesOf(vtkPointSet* data)
{
    VtkLines lines;
    auto* poly = vtkPolyData::SafeDownCast(data);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    const bool isSound = poly ? addCells(poly, lines) : grid && addCells(grid, lines);
    if (!isSound) {
        return std::nullopt;
    }
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        lines.set.points.emplace_back(data->GetPoint(i));
    }
    lines.pointArrays = scalarArrays(data->GetPointData());
    lines.cellArrays = scalarArrays(data->GetCellData());
    if (auto* names = vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray("Name"))) {
        for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i) {
            lines.cellNames.push_back(names->GetValue(i));
        }
    }
    lines.header = headerIn(data->GetFieldData());
    return lines;
}

}   // namespace angiopose::io
