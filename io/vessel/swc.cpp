#include "io/vessel/swc.h"

#include "io/support/file_error.h"
#include "io/support/numbers.h"

#include <array>
#include <unordered_map>

namespace io {
namespace {

/// id, type, x, y, z, radius, parent.
using SwcRow = std::array<double, 7>;

std::optional<SwcRow> parseRow(std::string_view line)
{
    SwcRow row{};
    for (double& value : row) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(" \t"));
        const auto number = parseNumber(word);
        if (!number) {
            return std::nullopt;
        }
        value = *number;
        line.remove_prefix(word.size());
    }
    return row;
}

}   // namespace

core::Result<LineSet> parseSwc(std::string_view text, double unitMm, const std::string& path)
{
    LineSet set;
    std::unordered_map<long, std::size_t> indexOfId;
    std::vector<std::pair<long, int>> parents;   // of each point, with its line in the file
    int lineNumber = 0;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view line = trimmed(text.substr(start, end - start));
        start = end + 1;
        ++lineNumber;
        if (line.empty() || line.front() == '#') {
            continue;
        }
        const auto row = parseRow(line);
        if (!row || !(std::abs((*row)[0]) < 1e9) || !(std::abs((*row)[6]) < 1e9)) {
            return fileError(path, "line " + std::to_string(lineNumber) +
                                       " is not `id type x y z radius parent`. Correct the line or export it again.");
        }
        if (!indexOfId.emplace(static_cast<long>((*row)[0]), set.points.size()).second) {
            return fileError(path, "line " + std::to_string(lineNumber) + " repeats an id. Ids must be unique.");
        }
        set.points.emplace_back(unitMm * (*row)[2], unitMm * (*row)[3], unitMm * (*row)[4]);
        set.radius.push_back(unitMm * (*row)[5]);
        parents.emplace_back(static_cast<long>((*row)[6]), lineNumber);
    }
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i].first < 0) {
            continue;
        }
        const auto parent = indexOfId.find(parents[i].first);
        if (parent == indexOfId.end()) {
            return fileError(path, "line " + std::to_string(parents[i].second) + " names a parent, " +
                                       std::to_string(parents[i].first) +
                                       ", that is not there. Export the whole tree.");
        }
        set.lines.push_back({parent->second, i});
    }
    return set;
}

}   // namespace io
