#include "io/support/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace angiopose::io {
namespace {

constexpr std::string_view padding(" \t\r\n\v\f\0", 7);   // includes the null byte that DICOM uses for padding

template <class Number>
std::optional<Number> parseAll(std::string_view text)
{
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

}   // namespace

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(padding);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(padding) - first + 1);
}

std::string toLower(std::string_view text)
{
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

std::optional<double> parseNumber(std::string_view text)
{
    return parseAll<double>(text);
}

std::optional<int> parseInteger(std::string_view text)
{
    return parseAll<int>(text);
}

std::string toText(double value)
{
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

}   // namespace angiopose::io
