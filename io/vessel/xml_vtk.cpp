#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/quiet_libraries.h"
#include "io/vessel/vtk_lines.h"
#include "io/vessel/vtk_point_set.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <optional>
#include <span>

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

/// The value of the attribute `type` of a tag, in either kind of quotes; empty where it has none.
std::string_view typeOf(std::string_view tag)
{
    constexpr std::string_view name = "type=";
    const std::size_t at = tag.find(name);
    if (at == std::string_view::npos || at + name.size() >= tag.size()) {
        return {};
    }
    const std::string_view value = tag.substr(at + name.size());
    return value.substr(1, value.find(value.front(), 1) - 1);
}

/// Whether every array says a type that there is: without one VTK reads through a null pointer.
bool areArraysTyped(std::string_view content)
{
    static constexpr std::array<std::string_view, 13> types{"Int8",   "UInt8", "Int16",    "UInt16",  "Int32",
                                                            "UInt32", "Int64", "UInt64",   "Float32", "Float64",
                                                            "String", "Bit",   "vtkIdType"};
    content = content.substr(0, content.find("<AppendedData"));
    for (const std::string_view element : {std::string_view("<DataArray"), std::string_view("<Array")}) {
        for (std::size_t at = content.find(element); at != std::string_view::npos;
             at = content.find(element, at + element.size())) {
            const std::string_view tag = content.substr(at, content.substr(at).find('>'));
            if (std::ranges::find(types, typeOf(tag)) == types.end()) {
                return false;
            }
        }
    }
    return true;
}

/// Remembers that a reader complained; without an observer VTK only prints.
class ErrorFlag : public vtkCommand {
public:
    static ErrorFlag* New() { return new ErrorFlag; }
    void Execute(vtkObject*, unsigned long, void*) override { raised = true; }
    bool raised = false;
};

/// A reader that notices where the file holds less of an array than it declares: VTK then leaves the rest as the memory
/// was, and says nothing.
template <class Reader>
class WholeArrays : public Reader {
public:
    static WholeArrays* New()
    {
        auto* reader = new WholeArrays;
        reader->InitializeObjectBase();
        return reader;
    }

    bool isShort() const { return isShort_; }

protected:
    int ReadArrayValues(vtkXMLDataElement* element, vtkIdType arrayIndex, vtkAbstractArray* array, vtkIdType startIndex,
                        vtkIdType valueCount, vtkXMLReader::FieldType type) override
    {
        const auto read = [&] {
            return Reader::ReadArrayValues(element, arrayIndex, array, startIndex, valueCount, type);
        };
        if (vtkDataArray::FastDownCast(array) == nullptr || array->GetDataType() == VTK_BIT || valueCount <= 0) {
            return read();
        }
        auto* last = static_cast<std::uint8_t*>(array->GetVoidPointer(arrayIndex + valueCount - 1));
        for (const std::uint8_t mark :
             {std::uint8_t{0xa5}, std::uint8_t{0x5a}}) {   // a value that is one mark by chance is not the other
            const std::span bytes(last, static_cast<std::size_t>(array->GetDataTypeSize()));
            std::ranges::fill(bytes, mark);
            const int result = read();
            if (result == 0 || std::ranges::any_of(bytes, [mark](std::uint8_t byte) { return byte != mark; })) {
                return result;
            }
        }
        isShort_ = true;
        return 0;
    }

private:
    bool isShort_ = false;
};

template <class Reader>
vtkSmartPointer<vtkPointSet> readWith(std::string_view content)
{
    const vtkNew<WholeArrays<Reader>> reader;
    const vtkNew<ErrorFlag> flag;
    reader->AddObserver(vtkCommand::ErrorEvent, flag);
    reader->ReadFromInputStringOn();
    reader->SetInputString(std::string(content));
    reader->Update();
    if (flag->raised || reader->isShort() || reader->GetErrorCode() != 0) {
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
    if (!areArraysTyped(content)) {
        return fileError(path, says::vtkXmlDamaged());
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