#include "app/decode/vtk_formats.h"
#include "app/decode/vtk_reading.h"
#include "io/decode/vtk_lines_reply.h"
#include "io/support/numbers.h"
#include "io/support/text_cursor.h"
#include "io/vessel/vtk_point_set.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <optional>
#include <regex>

namespace angiopose::decode {
namespace {

using io::DecoderReply;
using io::ReplyKind;

/// Element declared in the header. Sizes are counts of numbers for a text file and bytes for a binary file.
struct Element {
    std::string name;
    std::size_t count = 0;
    std::size_t entrySize = 0;   ///< size of an entry without its lists
    std::size_t listCount = 0;
    std::size_t cornerSize = 0;   ///< size of one vertex index in a face's list
    std::string coordinates;   ///< those of x, y and z that are declared
};

struct Header {
    bool isText = false;
    std::vector<Element> elements;
};

/// Returns the byte size of a PLY scalar type, or 0 if the type is unknown.
std::size_t sizeOf(const std::string& type)
{
    static const std::map<std::string, std::size_t> sizes = {
        {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
        {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = sizes.find(type);
    return found == sizes.end() ? 0 : found->second;
}

/// Adds "property list COUNT TYPE NAME" or a property without a list; returns false if a type is unknown.
bool addProperty(const std::string& countType, const std::string& type, const std::string& name, bool isText,
                 Element& element)
{
    const bool isList = !countType.empty();
    const std::size_t size = isText ? 1 : sizeOf(type), countSize = isText ? 1 : sizeOf(countType);
    element.entrySize += isList ? countSize : size;
    element.listCount += isList ? 1 : 0;
    element.cornerSize = isList && name.starts_with("vertex_ind") ? size : element.cornerSize;
    element.coordinates += !isList && (name == "x" || name == "y" || name == "z") ? name : "";
    return sizeOf(type) > 0 && (!isList || sizeOf(countType) > 0);
}

/// Reads the header up to the first value; nullopt if a line is not valid in a PLY header (VTK would skip it).
std::optional<Header> readHeader(io::TextReader& lines)
{
    static const std::regex known(
        R"(ply|(?:comment|obj_info).*|format\s+(ascii|binary_little_endian|binary_big_endian)\s+1\.0|)"
        R"(element\s+(\S+)\s+(\d{1,9})|property\s+(?:list\s+(\w+)\s+)?(\w+)\s+(\S+)|(end_header))");
    Header header;
    std::smatch words;
    for (std::string line; lines.left() > 0;) {
        line = lines.line();
        if (!std::regex_match(line, words, known)) {
            return std::nullopt;
        }
        if (words[1].matched) {
            header.isText = words[1] == "ascii";
        } else if (words[2].matched) {
            header.elements.push_back({words[2], std::stoul(words[3]), 0, 0, 0, {}});
        } else if (words[6].matched &&
                   (header.elements.empty() ||
                    !addProperty(words[4], words[5], words[6], header.isText, header.elements.back()))) {
            return std::nullopt;
        } else if (words[7].matched) {
            return header;
        }
    }
    return std::nullopt;
}

/// Returns the size of the body: the count of numbers in a text file, or the bytes of a binary file. Returns nullopt if
/// a word of the text is not a number (VTK would read 0).
std::optional<std::size_t> sizeOfBody(io::TextReader body, bool isText)
{
    std::size_t count = 0;
    for (; isText && !body.isAtEnd(); ++count) {
        if (!io::parseNumber(body.word())) {
            return std::nullopt;
        }
    }
    return isText ? count : body.left();
}

/// Returns whether a body of that size fits the header with the given number of face vertices. VTK reads missing data
/// as zeros, and the vertex count of a face modulo 256. A binary body may be followed by a few extra bytes.
bool matchesHeader(const Header& header, std::size_t cornerCount, std::size_t bodySize)
{
    std::size_t size = 0, tail = 0, lists = 0;
    for (const Element& element : header.elements) {
        if (element.count > 0 && element.entrySize > bodySize / element.count) {
            return false;
        }
        size += element.count * element.entrySize + cornerCount * element.cornerSize;
        tail += header.isText ? element.cornerSize : 256 * element.cornerSize;
        lists += element.count > 0 ? element.listCount : 0;
    }
    return size <= bodySize && (lists > 1 || bodySize < size + tail);
}

DecoderReply refusal(const std::string& place)
{
    return {ReplyKind::Refusal, place};
}

}   // namespace

DecoderReply readPly(const std::string& path)
{
    const std::string content = readWholeFile(path);
    io::TextReader cursor(content);
    const auto header = readHeader(cursor);
    if (!header) {
        return refusal("header");
    }
    bool hasPoints = false, hasFaces = false;
    for (const Element& element : header->elements) {
        if (element.entrySize == 0 && element.count > 0) {
            return refusal("element " + element.name);
        }
        hasPoints |= element.name == "vertex" && element.coordinates == "xyz";
        hasFaces |= element.name == "face" && element.count > 0 && element.cornerSize > 0;
    }
    if (!hasFaces) {   // VTK does not read files without faces
        return {ReplyKind::Result, io::toReply({})};
    }
    const auto bodySize = sizeOfBody(cursor, header->isText);
    if (!hasPoints || !bodySize) {
        return refusal(hasPoints ? "data" : "header");
    }
    const vtkNew<vtkPLYReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(content);
    readOrThrow(*reader, [] { return "data"; });
    vtkPolyData* data = reader->GetOutput();
    const auto corners = static_cast<std::size_t>(data->GetPolys()->GetNumberOfConnectivityIds());
    auto lines = matchesHeader(*header, corners, *bodySize) ? io::linesOf(data) : std::nullopt;
    return lines ? DecoderReply{ReplyKind::Result, io::toReply(*lines)} : refusal("data");
}

}   // namespace angiopose::decode
