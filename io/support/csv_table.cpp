#include "io/support/csv_table.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace angiopose::io {
namespace {

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

/// Returns the end of the cell that starts at `start`: the next unquoted comma or the end of the line.
std::size_t endOfCell(std::string_view line, std::size_t start)
{
    const std::size_t first = std::min(line.find_first_not_of(" \t", start), line.size());
    if (first < line.size() && line[first] == '"') {
        for (std::size_t close = line.find('"', first + 1); close != std::string_view::npos;
             close = line.find('"', close + 1)) {
            if (line.substr(close + 1).starts_with('"')) {
                ++close;   // a doubled quote stands for one quote in the cell
                continue;
            }
            const std::size_t next = std::min(line.find_first_not_of(" \t\r", close + 1), line.size());
            if (next == line.size() || line[next] == ',') {
                return next;
            }
        }
    }
    return std::min(line.find(',', start), line.size());
}

std::vector<std::string_view> splitCells(std::string_view line)
{
    std::vector<std::string_view> cells;
    for (std::size_t start = 0; start <= line.size();) {
        const std::size_t comma = endOfCell(line, start);
        std::string_view cell = trimmed(line.substr(start, comma - start));
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
            cell = cell.substr(1, cell.size() - 2);
        }
        cells.push_back(cell);
        start = comma + 1;
    }
    return cells;
}

bool areNumbers(const std::vector<std::string_view>& cells)
{
    return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) { return parseNumber(cell).has_value(); });
}

bool isText(std::string_view text)
{
    return text.find('\0') == std::string_view::npos;
}

}   // namespace

std::optional<std::size_t> CsvTable::column(std::string_view name) const
{
    const auto found = std::find(columns.begin(), columns.end(), name);
    return found == columns.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - columns.begin()));
}

core::Result<CsvTable> parseCsv(std::string_view text, const std::string& path)
{
    if (!isText(text)) {
        return fileError(path, messages::tableNoText());
    }
    if (text.starts_with(byteOrderMark)) {
        text.remove_prefix(byteOrderMark.size());
    }
    CsvTable table;
    table.path = path;
    std::size_t width = 0;
    for (LineReader lines(text); lines.next();) {
        std::vector<std::string_view> cells = splitCells(lines.line());
        if (width == 0) {
            width = cells.size();
            table.hasHeader = !areNumbers(cells);
            if (table.hasHeader) {
                std::transform(cells.begin(), cells.end(), std::back_inserter(table.columns), toLower);
                continue;
            }
        }
        if (cells.size() != width) {
            return fileError(path, messages::tableColumns(lines.number(), cells.size(), width));
        }
        table.rows.push_back(std::move(cells));
        table.lineOfRow.push_back(lines.number());
    }
    return table;
}

std::string csvCell(std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        return std::string(text);
    }
    std::string quoted = "\"";
    for (const char letter : text) {
        quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    }
    return quoted + "\"";
}

core::Result<double> numberInCell(const CsvTable& table, std::size_t row, std::size_t column)
{
    const std::string_view cell = table.rows[row][column];
    const std::optional<double> value = parseNumber(cell);
    if (value && std::isfinite(*value)) {
        return *value;
    }
    const std::string name = column < table.columns.size() ? table.columns[column] : std::to_string(column + 1);
    return fileError(table.path, messages::tableNoNumber(table.lineOfRow[row], name, cell.substr(0, 40)));
}

core::Result<int> branchIdInCell(const CsvTable& table, std::size_t row, std::size_t column)
{
    if (const auto id = parseInteger(table.rows[row][column])) {
        return *id;
    }
    return fileError(table.path, messages::tableBranchNoNumber(table.lineOfRow[row]));
}

}   // namespace angiopose::io
