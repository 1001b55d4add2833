#include "io/case/batch_manifest.h"

#include "io/messages/messages.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace angiopose::io {
namespace {

constexpr std::size_t rowDigits = 4;   ///< pads row numbers, so that the folders sort in row order
constexpr std::string_view settingPrefix = "set.";

std::string cellOf(const CsvTable& table, std::size_t row, std::string_view column)
{
    const auto index = table.column(column);
    return index ? std::string(table.rows[row][*index]) : "";
}

std::string defaultName(std::size_t row, const std::string& casePath)
{
    const std::string number = std::to_string(row + 1);
    return std::string(rowDigits - std::min(rowDigits, number.size()), '0') + number + "-" +
           std::filesystem::path(casePath).stem().string();
}

core::Status readPaths(BatchEntry& entry, const CsvTable& table, std::size_t row)
{
    const int line = table.lineOfRow[row];
    entry.caseCell = cellOf(table, row, "case");
    entry.vesselsCell = cellOf(table, row, "vessels");
    entry.angiogramCell = cellOf(table, row, "angiogram");
    const bool hasInput = !entry.vesselsCell.empty() || !entry.angiogramCell.empty();
    const bool hasInputs = !entry.vesselsCell.empty() && !entry.angiogramCell.empty();
    if (!entry.caseCell.empty() && hasInput) {
        return fileError(table.path, messages::batchNotBoth(line));
    }
    if (entry.caseCell.empty() && !hasInputs) {
        return fileError(table.path, messages::batchInputsLack(line));
    }
    const std::filesystem::path folder = std::filesystem::absolute(table.path).parent_path();
    const auto resolved = [&folder](const std::string& cell) {
        return cell.empty() ? cell : (folder / cell).lexically_normal().string();
    };
    entry.casePath = resolved(entry.caseCell);
    entry.vesselsPath = resolved(entry.vesselsCell);
    entry.angiogramPath = resolved(entry.angiogramCell);
    return core::Done{};
}

/// Converts "1 2 3; 4 5 6" to the value of vessel.tracing.seedsInPatientMm; nullopt if the text is not such a list.
std::optional<std::string> seedsValue(std::string_view cell)
{
    std::string value;
    for (std::size_t begin = 0; begin <= cell.size();) {
        const std::size_t end = std::min(cell.find(';', begin), cell.size());
        std::string_view rest = trimmed(cell.substr(begin, end - begin));
        std::string point;
        int count = 0;
        while (!rest.empty()) {
            const std::string_view word = rest.substr(0, std::min(rest.find_first_of(" \t"), rest.size()));
            const auto number = parseNumber(word);
            if (!number) {
                return std::nullopt;
            }
            point += (point.empty() ? "" : ",") + toText(*number);
            ++count;
            rest = trimmed(rest.substr(word.size()));
        }
        if (count != 3) {
            return std::nullopt;
        }
        value += (value.empty() ? "[" : ",[") + point + "]";
        begin = end + 1;
    }
    return "[" + value + "]";
}

core::Status readSettings(BatchEntry& entry, const CsvTable& table, std::size_t row)
{
    const int line = table.lineOfRow[row];
    if (const std::string seeds = cellOf(table, row, "seeds"); !seeds.empty()) {
        const auto value = seedsValue(seeds);
        if (!value || !entry.settings.add("vessel.tracing.seedsInPatientMm=" + *value)) {
            return fileError(table.path, messages::batchSeedsUnclear(line, seeds.substr(0, 40)));
        }
    }
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        const std::string& header = table.columns[column];
        const std::string cell(table.rows[row][column]);
        if (!header.starts_with(settingPrefix) || cell.empty()) {
            continue;
        }
        const core::Status added = entry.settings.add(header.substr(settingPrefix.size()) + "=" + cell);
        if (!added) {
            return fileError(table.path, messages::batchCell(line, header, added.error().message));
        }
    }
    return core::Done{};
}

core::Result<BatchEntry> parseEntry(const CsvTable& table, std::size_t row)
{
    const int line = table.lineOfRow[row];
    BatchEntry entry;
    entry.row = static_cast<int>(row) + 1;
    if (const auto read = readPaths(entry, table, row); !read) {
        return read.error();
    }
    entry.method = cellOf(table, row, "method");
    entry.name = cellOf(table, row, "name");
    if (entry.name.empty()) {
        entry.name = defaultName(row, entry.caseCell.empty() ? entry.angiogramCell : entry.caseCell);
    }
    if (entry.name.find('/') != std::string::npos || entry.name == "." || entry.name == "..") {
        return fileError(table.path, messages::batchNoFolderName(line, entry.name));
    }
    if (const std::string frame = cellOf(table, row, "frame"); !frame.empty()) {
        entry.frame = parseInteger(frame);
        if (!entry.frame) {
            return fileError(table.path, messages::batchFrameNoNumber(line, frame));
        }
        entry.frame = std::max(*entry.frame, 0) - 1;   // the manifest counts frames from 1
    }
    if (const auto read = readSettings(entry, table, row); !read) {
        return read.error();
    }
    return entry;
}

/// Checks the column names, including those of columns without values.
core::Status checkColumns(const CsvTable& table)
{
    const bool hasCase = table.column("case").has_value();
    const bool hasInputs = table.column("vessels") && table.column("angiogram");
    if ((!hasCase && !hasInputs) || table.rows.empty()) {
        return fileError(table.path, messages::batchHeaderMissing());
    }
    const std::vector<std::string> known = caseSettingNames();
    for (const std::string& column : table.columns) {
        const auto isKnown = [&column](const std::string& name) {
            return toLower(name) == column.substr(settingPrefix.size());
        };
        if (column.starts_with(settingPrefix) && std::ranges::none_of(known, isKnown)) {
            CaseSettings none;
            const core::Status refused = none.add(column.substr(settingPrefix.size()) + "=");
            return fileError(table.path, messages::batchCell(1, column, refused.error().message));
        }
    }
    return core::Done{};
}

}   // namespace

core::Result<std::vector<BatchEntry>> readManifest(const std::string& path)
{
    const auto content = openInput(path);
    if (!content) {
        return content.error();
    }
    const auto table = parseCsv(content.value().view(), path);
    if (!table) {
        return table.error();
    }
    if (const auto checked = checkColumns(table.value()); !checked) {
        return checked.error();
    }
    std::vector<BatchEntry> entries;
    std::set<std::string> names;
    for (std::size_t row = 0; row < table.value().rows.size(); ++row) {
        auto entry = parseEntry(table.value(), row);
        if (!entry) {
            return entry.error();
        }
        if (!names.insert(entry.value().name).second) {
            return fileError(path, messages::batchNameTwice(table.value().lineOfRow[row], entry.value().name));
        }
        entries.push_back(std::move(entry).value());
    }
    return entries;
}

}   // namespace angiopose::io
