#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/quiet_libraries.h"
#include "io/vessel/vtk_lines.h"
#include "io/vessel/vtk_point_set.h"

#include <vtkCommand.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
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
        const auto data =
            isGrid ? readWith<vtkXMLUnstructuredGridReader>(content) : readWith<vtkXMLPolyDataReader>(content);
        auto lines = linesOf(data);
        return lines ? core::Result<VtkLines>(std::move(*lines)) : fileError(path, says::vtkXmlDamaged());
    } catch (const std::bad_alloc&) {
        return fileError(path, says::fileLargerThanMemory());
    }
}

}   // namespace angiopose::io