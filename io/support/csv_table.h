#pragma once

#include "core/support/result.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Iterates over the trimmed lines of a text; skips empty lines and comments (`#`), which the line numbers include.
/// Usage: `for (LineReader lines(text); lines.next();) { use(lines.line(), lines.number()); }`
class LineReader {
public:
    explicit LineReader(std::string_view text) : remaining_(text) {}

    bool next()
    {
        while (!remaining_.empty()) {
            const std::size_t end = std::min(remaining_.find('\n'), remaining_.size());
            line_ = trimmed(remaining_.substr(0, end));
            remaining_.remove_prefix(std::min(end + 1, remaining_.size()));
            ++number_;
            if (!line_.empty() && line_.front() != '#') {
                return true;
            }
        }
        return false;
    }

    std::string_view line() const { return line_; }
    int number() const { return number_; }   ///< line number in the file, starting at 1

private:
    std::string_view remaining_;
    std::string_view line_;
    int number_ = 0;
};

/// Table of comma-separated values with a header row (names in lower case). Every row has as many cells as the header.
/// A comma inside quotes is part of the cell; doubled quotes are not replaced.
struct CsvTable {
    std::string path;   ///< path of the file from which the table was read, for messages
    std::vector<std::string> columns;
    std::vector<std::vector<std::string_view>> rows;   ///< cells, as views into the parsed text
    std::vector<int> lineOfRow;   ///< line number of each row in the file, starting at 1, for messages
    bool hasHeader = true;   ///< false if the first line contains numbers; `columns` is then empty

    std::optional<std::size_t> column(std::string_view name) const;
};

/// Parses UTF-8 text. Fails if the text is not a table or if rows have different lengths; the error names the line.
core::Result<CsvTable> parseCsv(std::string_view text, const std::string& path);

/// Formats a string as a cell, quoted if necessary.
std::string csvCell(std::string_view text);

/// Returns the number in a cell; fails unless it is finite. The error names the line and the column.
core::Result<double> numberInCell(const CsvTable& table, std::size_t row, std::size_t column);

/// Returns the branch ID in a cell; the error for an invalid ID names the line.
core::Result<int> branchIdInCell(const CsvTable& table, std::size_t row, std::size_t column);

}   // namespace angiopose::io
