#include "app/decode/vtk_formats.h"
#include "app/decode/vtk_reading.h"
#include "io/decode/vtk_lines_reply.h"
#include "io/vessel/vtk_point_set.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

namespace angiopose::decode {
namespace {

using io::DecoderReply;
using io::ReplyKind;

/// Records that a reader reported an error; without an observer, VTK would only print it.
class ErrorFlag : public vtkCommand {
public:
    static ErrorFlag* New() { return new ErrorFlag; }
    void Execute(vtkObject*, unsigned long, void*) override { raised = true; }
    bool raised = false;
};

/// Reader that detects arrays with fewer values in the file than declared. VTK leaves the missing values uninitialized
/// without an error.
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
        if (array->GetSize() < arrayIndex + valueCount) {   // VTK would write past the end of the array
            isShort_ = true;
            return 0;
        }
        if (vtkDataArray::FastDownCast(array) == nullptr || array->GetDataType() == VTK_BIT || valueCount <= 0) {
            return read();
        }
        auto* last = static_cast<std::uint8_t*>(array->GetVoidPointer(arrayIndex + valueCount - 1));
        for (const std::uint8_t mark : {std::uint8_t{0xa5}, std::uint8_t{0x5a}}) {   // a value cannot equal both marks
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
DecoderReply readWith(const std::string& path)
{
    const vtkNew<WholeArrays<Reader>> reader;
    const vtkNew<ErrorFlag> flag;
    reader->AddObserver(vtkCommand::ErrorEvent, flag);
    reader->ReadFromInputStringOn();
    reader->SetInputString(readWholeFile(path));
    reader->Update();
    if (flag->raised || reader->isShort() || reader->GetErrorCode() != 0) {
        return {};
    }
    const auto lines = io::linesOf(reader->GetOutput());
    return lines ? DecoderReply{ReplyKind::Result, io::toReply(*lines)} : DecoderReply();
}

}   // namespace

DecoderReply readXmlVtk(const std::string& path, const std::string& dataSet)
{
    return dataSet == "xml_polydata" ? readWith<vtkXMLPolyDataReader>(path)
                                     : readWith<vtkXMLUnstructuredGridReader>(path);
}

}   // namespace angiopose::decode
