#include "io/evaluation/table_text.h"

#include <algorithm>

namespace angiopose::io {
namespace {

/// Characters on screen; UTF-8 continuation bytes take no room.
std::size_t shownWidth(const std::string& text)
{
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string plainLine(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths)
{
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string padding(widths[i] - shownWidth(cells[i]), ' ');
        text += i == 0 ? cells[i] + padding : "  " + padding + cells[i];
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
}

std::vector<std::size_t> widthsOf(const core::ResultTable& table)
{
    std::vector<std::size_t> widths;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        widths.push_back(shownWidth(table.columns[k]));
        for (const core::ResultTable::Row& row : table.rows) {
            widths[k] = std::max(widths[k], shownWidth(row.cells[k]));
        }
    }
    return widths;
}

}   // namespace

std::string toPlainText(const core::ResultTable& table)
{
    const std::vector<std::size_t> widths = widthsOf(table);
    std::size_t total = 0;
    for (const std::size_t width : widths) {
        total += width + 2;
    }
    std::string text = (table.title.empty() ? "" : table.title + "\n") + plainLine(table.columns, widths) +
                       std::string(total - 2, '-') + "\n";
    for (const core::ResultTable::Row& row : table.rows) {
        text += plainLine(row.cells, widths);
    }
    return text;
}

}   // namespace angiopose::io