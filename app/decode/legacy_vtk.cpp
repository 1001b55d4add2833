#include "app/decode/vtk_formats.h"
#include "app/decode/vtk_reading.h"
#include "io/decode/vtk_lines_reply.h"
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
#include <charconv>
#include <limits>
#include <string_view>

namespace angiopose::decode {
namespace {

using io::DecoderReply;
using io::ReplyKind;

/// VTK's streams read no "nan" and no "inf": such a word of the text becomes a number that nothing measures, and comes
/// out as what it was.
struct StandIn {
    std::string_view word;
    std::string_view text;
    double number;
    double meaning;
};
constexpr std::array standIns = {
    StandIn{"nan", "5.192296858534828e33", 0x1p112, std::numeric_limits<double>::quiet_NaN()},
    StandIn{"inf", "1.0384593717069655e34", 0x1p113, std::numeric_limits<double>::infinity()}};

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
    for (const StandIn& standIn : standIns) {
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
    for (const StandIn& standIn : standIns) {
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

constexpr std::array sections = {"POINTS",          "VERTICES", "LINES",         "POLYGONS",
                                 "TRIANGLE_STRIPS", "CELLS",    "CELL_TYPES",    "POINT_DATA",
                                 "CELL_DATA",       "SCALARS",  "FIELD",         "VECTORS",
                                 "NORMALS",         "TENSORS",  "COLOR_SCALARS", "TEXTURE_COORDINATES",
                                 "LOOKUP_TABLE",    "METADATA"};

/// Where the last line before `end` lies that begins with that word, in capitals or not; npos where none does.
std::size_t lastLineOf(std::string_view section, std::string_view content, std::size_t end)
{
    std::string capitals = "\n" + std::string(section), small = capitals;
    std::transform(small.begin(), small.end(), small.begin(), lower);
    const std::size_t first = content.rfind(capitals, end), second = content.rfind(small, end);
    const std::size_t found = first == std::string_view::npos    ? second
                              : second == std::string_view::npos ? first
                                                                 : std::max(first, second);
    return found != std::string_view::npos && isBlankAt(content, found + capitals.size()) ? found
                                                                                          : std::string_view::npos;
}

/// The section that is being read at `end`.
std::string sectionAt(std::string_view content, std::size_t end)
{
    std::string last;
    std::size_t best = 0;
    for (const char* section : sections) {
        const std::size_t found = lastLineOf(section, content, end);
        if (found != std::string_view::npos && found >= best) {
            best = found;
            last = section;
        }
    }
    return last;
}

/// VTK does not compare how many cells a section declares with how many are in it.
bool holdsItsCells(std::string_view content, std::string_view section, vtkIdType cells)
{
    const std::size_t line = lastLineOf(section, content, std::string_view::npos);
    if (line == std::string_view::npos) {
        return cells == 0;
    }
    std::size_t start = line + 1 + section.size();
    while (start < content.size() && (content[start] == ' ' || content[start] == '\t')) {
        ++start;
    }
    vtkIdType declared = -1;
    std::from_chars(content.data() + start, content.data() + content.size(), declared);
    const bool hasOffsets = content.find("\nOFFSETS ") != std::string_view::npos;   // one more than cells
    return declared == cells || (hasOffsets && declared == cells + 1);
}

std::string sectionOfWrongCount(std::string_view content, vtkPointSet* data)
{
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data)) {
        return holdsItsCells(content, "CELLS", grid->GetNumberOfCells()) ? "" : "CELLS";
    }
    auto* poly = vtkPolyData::SafeDownCast(data);
    const std::array counts = {
        std::pair("VERTICES", poly->GetNumberOfVerts()), std::pair("LINES", poly->GetNumberOfLines()),
        std::pair("POLYGONS", poly->GetNumberOfPolys()), std::pair("TRIANGLE_STRIPS", poly->GetNumberOfStrips())};
    for (const auto& [section, count] : counts) {
        if (!holdsItsCells(content, section, count)) {
            return section;
        }
    }
    return {};
}

template <class Reader>
DecoderReply readWith(const std::string& path)
{
    std::string content = contentOf(path);
    const std::string_view head = std::string_view(content).substr(0, 1024);
    if (head.find("\nASCII") != std::string_view::npos || head.find("\nascii") != std::string_view::npos) {
        putStandIns(content);
    }
    const vtkNew<Reader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(content);
    readOrRefuse(*reader, [&] {
        std::istream* stream = reader->GetIStream();
        const auto place = stream ? stream->rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in) : std::streampos(-1);
        return sectionAt(content, place < 0 ? content.size() : static_cast<std::size_t>(place));
    });
    const std::string damaged = sectionOfWrongCount(content, reader->GetOutput());
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
