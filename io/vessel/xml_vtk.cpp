#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/quiet_libraries.h"
#include "io/vessel/vtk_lines.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <algorithm>
#include <array>
#include <new>
#include <optional>

namespace angiopose::io {
namespace {

constexpr int maxDeclared = 20'000'000;

/// The reader reserves what the header declares before it looks at the data: refuse what no centreline can need.
std::optional<core::Message> findImpossibleCount(std::string_view content)
{
    constexpr std::array attributes = {"NumberOfPoints=\"", "NumberOfLines=\"",     "NumberOfVerts=\"",
                                       "NumberOfStrips=\"", "NumberOfPolys=\"",     "NumberOfCells=\"",
                                       "NumberOfTuples=\"", "NumberOfComponents=\""};
    for (const std::string_view attribute : attributes) {
        for (std::size_t at = content.find(attribute); at != std::string_view::npos;) {
            at += attribute.size();
            const std::string_view text = content.substr(at, content.substr(at, 64).find('"'));
            const auto value = parseInteger(text);
            const int limit = attribute.starts_with("NumberOfComponents") ? 1000 : maxDeclared;
            if (!value || *value < 0 || *value > limit) {
                return says::vtkXmlImpossibleCount(std::string(attribute) + std::string(text.substr(0, 40)) + "\"");
            }
            at = content.find(attribute, at);
        }
    }
    return {};
}

/// Remembers that a reader complained; without an observer VTK only prints.
class ErrorFlag : public vtkCommand {
public:
    static ErrorFlag* New() { return new ErrorFlag; }
    void Execute(vtkObject*, unsigned long, void*) override { raised = true; }
    bool raised = false;
};

template <class Reader>
vtkSmartPointer<vtkPointSet> readWith(std::string_view content)
{
    const vtkNew<Reader> reader;
    const vtkNew<ErrorFlag> flag;
    reader->AddObserver(vtkCommand::ErrorEvent, flag);
    reader->ReadFromInputStringOn();
    reader->SetInputString(std::string(content));
    reader->Update();
    if (flag->raised || reader->GetErrorCode() != 0) {
        return nullptr;
    }
    return reader->GetOutput();
}

/// Point ids of each cell; nothing when offsets go astray, which the reader does not check.
std::optional<VtkCells> cellsOf(vtkCellArray* array)
{
    if (!array) {
        return VtkCells();
    }
    vtkDataArray* offsets = array->GetOffsetsArray();
    double last = 0.0;
    for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i) {
        const double offset = offsets->GetComponent(i, 0);
        if (offset < last || offset > static_cast<double>(array->GetConnectivityArray()->GetNumberOfTuples())) {
            return std::nullopt;
        }
        last = offset;
    }
    VtkCells cells(static_cast<std::size_t>(array->GetNumberOfCells()));
    const vtkNew<vtkIdList> ids;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        array->GetCellAtId(static_cast<vtkIdType>(i), ids);
        cells[i].assign(ids->begin(), ids->end());   // negative becomes out of range, found later
    }
    return cells;
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

/// Slicer notes the axes in field data.
bool saysRas(vtkFieldData* data)
{
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
        auto* texts = vtkStringArray::SafeDownCast(data->GetAbstractArray(i));
        if (texts && texts->GetName() && std::string_view(texts->GetName()).starts_with("S") &&
            texts->GetNumberOfValues() > 0 && texts->GetValue(0).find("RAS") != std::string::npos) {
            return true;
        }
    }
    return false;
}

/// Nothing when the cells are damaged.
std::optional<VtkCellSections> sectionsOf(vtkPolyData* data)
{
    auto lines = cellsOf(data->GetLines()), polygons = cellsOf(data->GetPolys()), strips = cellsOf(data->GetStrips());
    if (!lines || !polygons || !strips) {
        return std::nullopt;
    }
    const auto vertexCount = static_cast<std::size_t>(data->GetNumberOfVerts());
    return VtkCellSections{vertexCount, std::move(*lines), std::move(*polygons), std::move(*strips), {}, {}};
}

std::optional<VtkCellSections> sectionsOf(vtkUnstructuredGrid* grid)
{
    auto cells = cellsOf(grid->GetCells());
    vtkUnsignedCharArray* types = grid->GetCellTypesArray();
    const std::size_t typeCount = types ? static_cast<std::size_t>(types->GetNumberOfValues()) : 0;
    if (!cells || cells->size() != typeCount) {
        return std::nullopt;
    }
    VtkCellSections sections;
    sections.mixed = std::move(*cells);
    for (std::size_t i = 0; i < typeCount; ++i) {
        sections.types.push_back(types->GetValue(static_cast<vtkIdType>(i)));
    }
    return sections;
}

core::Result<VtkLines> linesOf(vtkPointSet* data, const std::string& path)
{
    const core::Error damaged = fileError(path, says::vtkXmlDamaged());
    if (!data) {
        return damaged;
    }
    VtkLines lines;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        lines.set.points.emplace_back(data->GetPoint(i));
    }
    auto* poly = vtkPolyData::SafeDownCast(data);
    auto sections = poly ? sectionsOf(poly) : sectionsOf(vtkUnstructuredGrid::SafeDownCast(data));
    if (!sections) {
        return damaged;
    }
    addCells(std::move(*sections), lines);
    lines.pointArrays = scalarArrays(data->GetPointData());
    lines.cellArrays = scalarArrays(data->GetCellData());
    if (auto* names = vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray("Name"))) {
        for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i) {
            lines.cellNames.push_back(names->GetValue(i));
        }
    }
    lines.set.isRas = saysRas(data->GetFieldData());
    return lines;
}

}   // namespace

core::Result<VtkLines> parseXmlVtk(std::string_view content, const std::string& path)
{
    quietLibraries();
    if (const auto impossible = findImpossibleCount(content)) {
        return fileError(path, *impossible);
    }
    const std::string_view head = content.substr(0, 4096);
    const bool isGrid = head.find("type=\"UnstructuredGrid\"") != std::string_view::npos;
    if (!isGrid && head.find("type=\"PolyData\"") == std::string_view::npos) {
        return fileError(path, says::vtkXmlOther());
    }
    try {
        return linesOf(
            isGrid ? readWith<vtkXMLUnstructuredGridReader>(content) : readWith<vtkXMLPolyDataReader>(content), path);
    } catch (const std::bad_alloc&) {
        return fileError(path, says::fileLargerThanMemory());
    }
}

}   // namespace angiopose::io