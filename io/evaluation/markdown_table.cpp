#include "io/evaluation/table_text.h"

namespace angiopose::io {
namespace {

std::string escapedMarkdown(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        result += c == '|' || c == '*' || c == '_' || c == '<' ? std::string("\\") + c : std::string(1, c);
    }
    return result;
}

std::string markdownLine(const std::vector<std::string>& cells, const std::string& mark)
{
    std::string text = "|";
    for (const std::string& cell : cells) {
        text += " " + mark + escapedMarkdown(cell) + mark + " |";
    }
    return text + "\n";
}

}   // namespace

std::string toMarkdown(const core::ResultTable& table)
{
    std::string text = "### " + escapedMarkdown(table.title) + "\n\n" + markdownLine(table.columns, "");
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        text += k == 0 ? "|---" : "|---:";
    }
    text += "|\n";
    for (const core::ResultTable::Row& row : table.rows) {
        text += markdownLine(row.cells, row.isPublished ? "*" : "");
    }
    for (const std::string& note : table.notes) {
        text += "\n" + escapedMarkdown(note) + "\n";
    }
    return text;
}

}   // namespace angiopose::io