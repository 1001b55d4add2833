#include "io/support/text_cursor.h"

#include "io/support/numbers.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

}   // namespace

bool TextReader::isAtEnd() const
{
    return remaining_.find_first_not_of(blanks) == std::string_view::npos;
}

std::string_view TextReader::taken(std::size_t count)
{
    const std::string_view result = remaining_.substr(0, count);
    remaining_.remove_prefix(result.size());
    return result;
}

std::string_view TextReader::line()
{
    const std::size_t end = remaining_.find('\n');
    return trimmed(taken(end == std::string_view::npos ? end : end + 1));
}

std::string_view TextReader::word()
{
    taken(std::min(remaining_.find_first_not_of(blanks), remaining_.size()));
    return taken(std::min(remaining_.find_first_of(blanks), remaining_.size()));
}

std::optional<Eigen::Vector3d> TextReader::point()
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

}   // namespace angiopose::io
