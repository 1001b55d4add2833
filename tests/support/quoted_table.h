#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace angiopose::test {

/// A comma-separated table parsed as by spreadsheets: quoted cells may contain commas.
class QuotedTable {
public:
    explicit QuotedTable(const std::string& text) : rows_{{""}}
    {
        bool isQuoted = false;
        for (const char letter : text) {
            if (letter == '"') {
                isQuoted =
                    !isQuoted;   // a doubled quote ends and restarts the quotation; the quote itself is not needed here
            } else if (letter == ',' && !isQuoted) {
                rows_.back().emplace_back();
            } else if (letter == '\n' && !isQuoted) {
                rows_.push_back({""});
            } else {
                rows_.back().back() += letter;
            }
        }
        rows_.pop_back();   // the empty row after the last line
    }

    std::size_t rowCount() const { return rows_.size() - 1; }
    bool isEven() const
    {
        return std::ranges::all_of(rows_, [this](const auto& row) { return row.size() == rows_.front().size(); });
    }
    /// Cell of a row below the header; "no such column" if the column does not exist.
    std::string cell(std::size_t row, const std::string& column) const
    {
        const auto found = std::ranges::find(rows_.front(), column);
        return found == rows_.front().end() ? "no such column"
                                            : rows_[row + 1][static_cast<std::size_t>(found - rows_.front().begin())];
    }

private:
    std::vector<std::vector<std::string>> rows_;
};

}   // namespace angiopose::test
