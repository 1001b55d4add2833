#include "io/case/batch_manifest.h"

#include "io/messages/says.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace angiopose::io {
namespace {

constexpr std::size_t rowDigits = 4;   ///< folders then sort as rows do

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

core::Result<BatchEntry> parseEntry(const CsvTable& table, std::size_t row)
{
    const int line = table.lineOfRow[row];
    const std::string casePath = cellOf(table, row, "case");
    if (casePath.empty()) {
        return fileError(table.path, says::batchNoCase(line));
    }
    BatchEntry entry;
    entry.row = static_cast<int>(row) + 1;
    entry.casePath = (std::filesystem::path(table.path).parent_path() / casePath).string();
    entry.method = cellOf(table, row, "method");
    entry.name = cellOf(table, row, "name");
    if (entry.name.empty()) {
        entry.name = defaultName(row, casePath);
    }
    if (entry.name.find('/') != std::string::npos || entry.name == "." || entry.name == "..") {
        return fileError(table.path, says::batchNoFolderName(line, entry.name));
    }
    if (const std::string frame = cellOf(table, row, "frame"); !frame.empty()) {
        entry.frame = parseInteger(frame);
        if (!entry.frame) {
            return fileError(table.path, says::batchFrameNoNumber(line, frame));
        }
    }
    return entry;
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
    if (!table.value().column("case") || table.value().rows.empty()) {
        return fileError(path, says::batchNoHeader());
    }
    std::vector<BatchEntry> entries;
    std::set<std::string> names;
    for (std::size_t row = 0; row < table.value().rows.size(); ++row) {
        auto entry = parseEntry(table.value(), row);
        if (!entry) {
            return entry.error();
        }
        if (!names.insert(entry.value().name).second) {
            return fileError(path, says::batchNameTwice(table.value().lineOfRow[row], entry.value().name));
        }
        entries.push_back(std::move(entry).value());
    }
    return entries;
}

}   // namespace angiopose::io