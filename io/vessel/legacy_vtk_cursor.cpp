#include "io/vessel/legacy_vtk_cursor.h"

#include "io/support/numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace angiopose::io {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

/// Big-endian value at `bytes`.
template <class Number>
double decode(const char* bytes)
{
    std::array<char, sizeof(Number)> swapped;
    std::reverse_copy(bytes, bytes + sizeof(Number), swapped.begin());
    return static_cast<double>(std::bit_cast<Number>(swapped));
}

struct BinaryType {
    std::string_view name;
    std::size_t size;
    double (*read)(const char*);
};

constexpr std::array binaryTypes = {
    BinaryType{"float", 4, decode<float>},
    BinaryType{"double", 8, decode<double>},
    BinaryType{"int", 4, decode<std::int32_t>},
    BinaryType{"unsigned_int", 4, decode<std::uint32_t>},
    BinaryType{"short", 2, decode<std::int16_t>},
    BinaryType{"unsigned_short", 2, decode<std::uint16_t>},
    BinaryType{"char", 1, decode<std::int8_t>},
    BinaryType{"signed_char", 1, decode<std::int8_t>},
    BinaryType{"unsigned_char", 1, decode<std::uint8_t>},
    BinaryType{"long", 8, decode<std::int64_t>},
    BinaryType{"unsigned_long", 8, decode<std::uint64_t>},
    BinaryType{"vtktypeint64", 8, decode<std::int64_t>},
    BinaryType{"vtktypeuint64", 8, decode<std::uint64_t>},
    BinaryType{"vtkidtype", 4, decode<std::int32_t>},   // written as int, whatever the build
};

bool equalIgnoringCase(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
        const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
        return lower(x) == lower(y);
    });
}

}   // namespace

bool LegacyVtkCursor::isAtEnd()
{
    return rest_.find_first_not_of(blanks) == std::string_view::npos;
}

std::string_view LegacyVtkCursor::line()
{
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view result = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return result;
}

std::string_view LegacyVtkCursor::token()
{
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    const std::string_view result = rest_.substr(0, rest_.find_first_of(blanks));
    rest_.remove_prefix(result.size());
    return result;
}

std::string_view LegacyVtkCursor::peekToken()
{
    const std::string_view before = rest_;
    const std::string_view result = token();
    rest_ = before;
    return result;
}

std::optional<std::size_t> LegacyVtkCursor::count()
{
    const std::optional<int> value = parseInteger(token());
    return value && *value >= 0 ? std::optional(static_cast<std::size_t>(*value)) : std::nullopt;
}

std::optional<std::vector<double>> LegacyVtkCursor::numbers(std::size_t count, std::string_view type)
{
    return isBinary_ ? binaryNumbers(count, type) : asciiNumbers(count);
}

bool LegacyVtkCursor::skipNumbers(std::size_t count, std::string_view type)
{
    return numbers(count, type).has_value();
}

std::optional<std::vector<double>> LegacyVtkCursor::asciiNumbers(std::size_t count)
{
    if (count > rest_.size()) {   // every value takes at least one character
        return std::nullopt;
    }
    std::vector<double> values;
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double> value = parseNumber(token());
        if (!value) {
            return std::nullopt;
        }
        values.push_back(*value);
    }
    return values;
}

std::optional<std::vector<double>> LegacyVtkCursor::binaryNumbers(std::size_t count, std::string_view type)
{
    line();   // the values start after the end of the line that announces them
    const auto known = std::find_if(binaryTypes.begin(), binaryTypes.end(),
                                    [&](const BinaryType& t) { return equalIgnoringCase(t.name, type); });
    if (known == binaryTypes.end() || count > rest_.size() / known->size) {
        return std::nullopt;
    }
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = known->read(rest_.data() + i * known->size);
    }
    rest_.remove_prefix(count * known->size);
    return values;
}

std::optional<std::size_t> LegacyVtkCursor::binaryStringLength()
{
    // The two highest bits of the first byte tell how many bytes the length takes (vtkDataReader).
    if (rest_.empty()) {
        return std::nullopt;
    }
    const auto first = static_cast<unsigned char>(rest_.front());
    const std::size_t bytes = std::size_t{8} >> (first >> 6);
    if (rest_.size() < bytes) {
        return std::nullopt;
    }
    std::size_t length = first & 0x3fU;
    for (std::size_t i = 1; i < bytes; ++i) {
        length = (length << 8) | static_cast<unsigned char>(rest_[i]);
    }
    rest_.remove_prefix(bytes);
    return length;
}

std::optional<std::vector<std::string>> LegacyVtkCursor::strings(std::size_t count)
{
    line();
    if (count > rest_.size()) {
        return std::nullopt;
    }
    std::vector<std::string> values;
    for (std::size_t i = 0; i < count; ++i) {
        if (!isBinary_) {
            values.emplace_back(line());
            continue;
        }
        const std::optional<std::size_t> length = binaryStringLength();
        if (!length || *length > rest_.size()) {
            return std::nullopt;
        }
        values.emplace_back(rest_.substr(0, *length));
        rest_.remove_prefix(*length);
    }
    return values;
}

void LegacyVtkCursor::skipParagraph()
{
    while (!rest_.empty() && !line().empty()) {
    }
}

}   // namespace angiopose::io