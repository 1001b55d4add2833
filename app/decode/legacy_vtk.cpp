#include "app/decode/vtk_formats.h"
#include "app/decode/vtk_reading.h"
#include "io/decode/vtk_lines_reply.h"
#include "io/support/numbers.h"
#include "io/support/text_cursor.h"
#include "io/vessel/vtk_point_set.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <set>
#include <string_view>

namespace angiopose::decode {
namespace {

using io::DecoderReply;
using io::ReplyKind;

/// Replacement for "nan" and "inf", which VTK's streams cannot read: the word is replaced before reading by a number
/// that no measurement has, which is replaced by the original value after reading.
struct NumberPlaceholder {
    std::string_view word;
    std::string_view text;
    double number;
    double meaning;
};
constexpr std::array standIns = {
    NumberPlaceholder{"nan", "5.192296858534828e33", 0x1p112, std::numeric_limits<double>::quiet_NaN()},
    NumberPlaceholder{"inf", "1.0384593717069655e34", 0x1p113, std::numeric_limits<double>::infinity()}};

bool isBlankAt(std::string_view text, std::size_t at)
{
    return at >= text.size() || std::isspace(static_cast<unsigned char>(text[at])) != 0;
}

char lower(char letter)
{
    return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

void putStandIns(std::string& text)
{
    for (const NumberPlaceholder& standIn : standIns) {
        const auto isSame = [](char left, char right) { return lower(left) == right; };
        auto at = text.begin();
        while ((at = std::search(at, text.end(), standIn.word.begin(), standIn.word.end(), isSame)) != text.end()) {
            const auto start = static_cast<std::size_t>(at - text.begin());
            const std::size_t signs = start > 0 && (text[start - 1] == '-' || text[start - 1] == '+') ? 1 : 0;
            const bool isWord =
                start > signs && isBlankAt(text, start - signs - 1) && isBlankAt(text, start + standIn.word.size());
            if (isWord) {
                text.replace(start, standIn.word.size(), standIn.text);
            }
            at = text.begin() + static_cast<std::ptrdiff_t>(start + (isWord ? standIn.text.size() : 1));
        }
    }
}

void takeStandIn(double& value)
{
    for (const NumberPlaceholder& standIn : standIns) {
        value = value == standIn.number ? standIn.meaning : value == -standIn.number ? -standIn.meaning : value;
    }
}

void takeStandIns(io::VtkLines& lines)
{
    for (Eigen::Vector3d& point : lines.set.points) {
        std::for_each(point.begin(), point.end(), takeStandIn);
    }
    for (auto* arrays : {&lines.pointArrays, &lines.cellArrays}) {
        for (auto& [name, values] : *arrays) {
            std::for_each(values.begin(), values.end(), takeStandIn);
        }
    }
}

/// Section header in the file, such as "LINES 2 8".
struct Section {
    std::string name;   ///< name in upper case
    std::size_t at = 0;
    vtkIdType cells = 0;   ///< declared number of cells; another number, or 0, for other sections
};

/// Finds the sections in file order. A line of binary data looks like a section header with a probability of about one
/// in a billion.
std::vector<Section> sectionsIn(std::string_view content)
{
    static const std::set<std::string, std::less<>> known = {
        "POINTS",     "VERTICES",   "LINES",        "POLYGONS", "TRIANGLE_STRIPS", "CELLS",
        "CELL_TYPES", "POINT_DATA", "CELL_DATA",    "SCALARS",  "FIELD",           "VECTORS",
        "NORMALS",    "TENSORS",    "LOOKUP_TABLE", "METADATA", "COLOR_SCALARS",   "TEXTURE_COORDINATES"};
    std::vector<Section> sections;
    std::size_t end = content.find('\n', content.find('\n') + 1);   // end of the title line, which may contain anything
    for (; end != std::string_view::npos; end = content.find('\n', end + 1)) {
        if (end + 1 == content.size() || std::isalpha(static_cast<unsigned char>(content[end + 1])) == 0) {
            continue;
        }
        io::TextReader words(content.substr(end + 1, 80));
        std::string name(words.word());
        std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
        if (name == "OFFSETS" && !sections.empty()) {
            --sections.back().cells;   // file format version 5 declares the number of offsets, one more than cells
        } else if (known.contains(name)) {
            sections.push_back({name, end, io::parseInteger(words.word()).value_or(0)});
        }
    }
    return sections;
}

/// Returns the name of the section that contains the position; empty if there is none.
std::string sectionAt(const std::vector<Section>& sections, std::size_t place)
{
    const auto next = std::find_if(sections.begin(), sections.end(), [&](const auto& each) { return each.at > place; });
    return next == sections.begin() ? std::string() : std::prev(next)->name;
}

/// Compares the number of cells read with the declared number, since VTK does not.
bool hasDeclaredCells(const std::vector<Section>& sections, std::string_view name, vtkIdType cells)
{
    const auto section =
        std::find_if(sections.begin(), sections.end(), [&](const auto& each) { return each.name == name; });
    return cells == (section == sections.end() ? 0 : section->cells);
}

std::string sectionOfWrongCount(const std::vector<Section>& sections, vtkPointSet* data)
{
    std::vector<std::pair<std::string, vtkIdType>> counts;
    if (auto* poly = vtkPolyData::SafeDownCast(data)) {
        counts = {{"VERTICES", poly->GetNumberOfVerts()},
                  {"LINES", poly->GetNumberOfLines()},
                  {"POLYGONS", poly->GetNumberOfPolys()},
                  {"TRIANGLE_STRIPS", poly->GetNumberOfStrips()}};
    } else {
        counts = {{"CELLS", data->GetNumberOfCells()}};
    }
    const auto wrong = std::find_if(counts.begin(), counts.end(), [&](const auto& each) {
        return !hasDeclaredCells(sections, each.first, each.second);
    });
    return wrong == counts.end() ? std::string() : wrong->first;
}

template <class Reader>
DecoderReply readWith(const std::string& path)
{
    std::string content = readWholeFile(path);
    const std::string_view head = std::string_view(content).substr(0, 1024);
    if (head.find("\nASCII") != std::string_view::npos || head.find("\nascii") != std::string_view::npos) {
        putStandIns(content);
    }
    const std::vector<Section> sections = sectionsIn(content);
    const vtkNew<Reader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(content);
    readOrThrow(*reader, [&] {
        std::istream* stream = reader->GetIStream();
        const auto place = stream ? stream->rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in) : std::streampos(-1);
        return sectionAt(sections, place < 0 ? content.size() : static_cast<std::size_t>(place));
    });
    const std::string damaged = sectionOfWrongCount(sections, reader->GetOutput());
    auto lines = damaged.empty() ? io::linesOf(reader->GetOutput()) : std::nullopt;
    if (!lines) {
        return {ReplyKind::Refusal, damaged};
    }
    takeStandIns(*lines);
    return {ReplyKind::Result, io::toReply(*lines)};
}

}   // namespace

DecoderReply readLegacyVtk(const std::string& path, const std::string& dataSet)
{
    return dataSet == "polydata" ? readWith<vtkPolyDataReader>(path) : readWith<vtkUnstructuredGridReader>(path);
}

}   // namespace angiopose::decode
