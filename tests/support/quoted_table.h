#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace angiopose::test {

/// A comma-separated table as spreadsheets read it: cells in quotes may hold commas.
class QuotedTable {
public:
    explicit QuotedTable(const std::string& text) : rows_{{""}}
    {
        bool isQuoted = false;
        for (const char letter : text) {
            if (letter == '"') {
                isQuoted = !isQuoted;   // a doubled one leaves and enters again; the letter itself does not matter here
            } else if (letter == ',' && !isQuoted) {
                rows_.back().emplace_back();
            } else if (letter == '\n' && !isQuoted) {
                rows_.push_back({""});
            } else {
                rows_.back().back() += letter;
            }
        }
        rows_.pop_back();   // behind the last line
    }

    std::size_t rowCount() const { return rows_.size() - 1; }
    bool isEven() const
    {
        return std::ranges::all_of(rows_, [this](const auto& row) { return row.size() == rows_.front().size(); });
    }
    /// Of a row below the header; "no such column" where there is none.
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
