#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/surface/surface_formats.h"

#include <algorithm>

namespace angiopose::io {
namespace {

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

/// "12/3/4" → point 12 (from 1), "-1" → the last one so far; a number out of range stays so, to be found later.
std::size_t pointIndex(std::string_view word, std::size_t pointCount)
{
    const int index = parseInteger(word.substr(0, word.find('/'))).value_or(0);
    return static_cast<std::size_t>(index < 0 ? static_cast<long>(pointCount) + index : static_cast<long>(index) - 1);
}

}   // namespace

core::Result<PolygonSet> parseObj(std::string_view content, const std::string& path)
{
    PolygonSet set;
    for (std::size_t at = 0, line = 1; at < content.size(); ++line) {
        const std::size_t newline = std::min(content.find('\n', at), content.size());
        const auto words = wordsOf(content.substr(at, newline - at));
        at = newline + 1;
        if (words.empty()) {
            continue;
        }
        if (words[0] == "v") {
            Eigen::Vector3d point;
            for (int k = 0; k < 3; ++k) {
                const auto index = static_cast<std::size_t>(k) + 1;
                const auto number = index < words.size() ? parseNumber(words[index]) : std::nullopt;
                if (!number) {
                    return fileError(path, says::objBadPoint(line));
                }
                point[k] = *number;
            }
            set.points.push_back(point);
        } else if (words[0] == "f") {
            std::vector<std::size_t> polygon;
            for (std::size_t k = 1; k < words.size(); ++k) {
                polygon.push_back(pointIndex(words[k], set.points.size()));
            }
            set.polygons.push_back(std::move(polygon));
        }
    }
    return set;
}

}   // namespace angiopose::io