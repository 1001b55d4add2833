#include "io/vessel/legacy_vtk_cursor.h"

namespace angiopose::io {

std::optional<std::vector<double>> LegacyVtkCursor::numbers(std::size_t count, std::string_view type)
{
    if (!isText()) {
        line();   // the values start after the end of the line that announces them
    }
    return ValueCursor::numbers(count, numberTypeOf(type));
}

/// The two highest bits of the first byte tell how many bytes the length takes (vtkDataReader).
std::optional<std::size_t> LegacyVtkCursor::stringLength()
{
    const std::string_view start = bytes(1);
    const auto first = start.empty() ? 0U : static_cast<unsigned char>(start.front());
    const std::size_t more = (std::size_t{8} >> (first >> 6)) - 1;
    const std::string_view rest = bytes(more);
    if (start.empty() || rest.size() < more) {
        return std::nullopt;
    }
    std::size_t length = first & 0x3fU;
    for (const char byte : rest) {
        length = (length << 8) | static_cast<unsigned char>(byte);
    }
    return length;
}

std::optional<std::vector<std::string>> LegacyVtkCursor::strings(std::size_t count)
{
    line();
    if (count > left()) {
        return std::nullopt;
    }
    std::vector<std::string> values;
    for (std::size_t i = 0; i < count; ++i) {
        const auto length = isText() ? std::nullopt : stringLength();
        if (!isText() && (!length || *length > left())) {
            return std::nullopt;
        }
        values.emplace_back(isText() ? line() : bytes(*length));
    }
    return values;
}

void LegacyVtkCursor::skipParagraph()
{
    while (left() > 0 && !line().empty()) {
    }
}

}   // namespace angiopose::io
