#include "io/support/value_cursor.h"

#include "io/support/numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace angiopose::io {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

template <class Number>
double decoded(const char* bytes, bool isTurned)
{
    std::array<char, sizeof(Number)> raw;
    std::copy_n(bytes, raw.size(), raw.begin());
    if (isTurned) {
        std::reverse(raw.begin(), raw.end());
    }
    return static_cast<double>(std::bit_cast<Number>(raw));
}

template <class Number>
constexpr NumberType typeNamed(std::string_view names)
{
    return {names, sizeof(Number), decoded<Number>};
}

constexpr std::array numberTypes = {
    typeNamed<float>(" float float32 "),
    typeNamed<double>(" double float64 "),
    typeNamed<std::int8_t>(" char signed_char int8 "),
    typeNamed<std::uint8_t>(" uchar unsigned_char uint8 "),
    typeNamed<std::int16_t>(" short int16 "),
    typeNamed<std::uint16_t>(" ushort unsigned_short uint16 "),
    typeNamed<std::int32_t>(" int int32 vtkidtype "),   // ids are written as int, whatever the build
    typeNamed<std::uint32_t>(" uint unsigned_int uint32 "),
    typeNamed<std::int64_t>(" long vtktypeint64 "),
    typeNamed<std::uint64_t>(" unsigned_long vtktypeuint64 "),
};

}   // namespace

const NumberType* numberTypeOf(std::string_view name)
{
    const std::string word = " " + lowered(name) + " ";
    const auto* const found = std::find_if(numberTypes.begin(), numberTypes.end(), [&](const NumberType& type) {
        return type.names.find(word) != std::string_view::npos;
    });
    return found == numberTypes.end() ? nullptr : found;
}

bool ValueCursor::isAtEnd() const
{
    return rest_.find_first_not_of(blanks) == std::string_view::npos;
}

std::string_view ValueCursor::bytes(std::size_t count)
{
    const std::string_view result = rest_.substr(0, count);
    rest_.remove_prefix(result.size());
    return result;
}

std::string_view ValueCursor::line()
{
    const std::size_t end = rest_.find('\n');
    return trimmed(bytes(end == std::string_view::npos ? end : end + 1));
}

std::string_view ValueCursor::word()
{
    bytes(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    return bytes(std::min(rest_.find_first_of(blanks), rest_.size()));
}

std::optional<std::size_t> ValueCursor::count()
{
    const std::optional<int> value = parseInteger(word());
    return value && *value >= 0 ? std::optional(static_cast<std::size_t>(*value)) : std::nullopt;
}

std::optional<Eigen::Vector3d> ValueCursor::point()
{
    Eigen::Vector3d point;
    for (double& coordinate : point) {
        const std::optional<double> value = parseNumber(word());
        if (!value) {
            return std::nullopt;
        }
        coordinate = *value;
    }
    return point;
}

std::optional<double> ValueCursor::number(const NumberType& type)
{
    if (isText()) {
        return parseNumber(word());
    }
    const std::string_view raw = bytes(type.size);
    const bool isTurned = (coding_ == Coding::BigEndian) != (std::endian::native == std::endian::big);
    return raw.size() == type.size ? std::optional(type.read(raw.data(), isTurned)) : std::nullopt;
}

std::optional<std::vector<double>> ValueCursor::numbers(std::size_t count, const NumberType* type)
{
    // In text every value takes at least one character, whatever its type.
    const NumberType& known = type ? *type : numberTypes.front();
    if ((!type && !isText()) || count > left() / (isText() ? 1 : known.size)) {
        return std::nullopt;
    }
    std::vector<double> values(count);
    for (double& value : values) {
        const std::optional<double> given = number(known);
        if (!given) {
            return std::nullopt;
        }
        value = *given;
    }
    return values;
}

}   // namespace angiopose::io
