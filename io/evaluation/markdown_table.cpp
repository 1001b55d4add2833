#include "io/evaluation/table_text.h"

#include <algorithm>
#include <array>
#include <string_view>

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

/// Returns the number of displayed characters, that is, bytes that are not UTF-8 continuation bytes.
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

struct Replacement {
    std::string_view text;
    std::string_view latex;
};

constexpr std::array replacements{
    Replacement{"\\", "\\textbackslash{}"},
    Replacement{"&", "\\&"},
    Replacement{"%", "\\%"},
    Replacement{"$", "\\$"},
    Replacement{"#", "\\#"},
    Replacement{"_", "\\_"},
    Replacement{"{", "\\{"},
    Replacement{"}", "\\}"},
    Replacement{"~", "\\textasciitilde{}"},
    Replacement{"^", "\\textasciicircum{}"},
    Replacement{"<", "$<$"},
    Replacement{">", "$>$"},
    Replacement{"°", "$^\\circ$"},
    Replacement{"–", "--"},
    Replacement{"×", "$\\times$"},
    Replacement{"±", "$\\pm$"},
    Replacement{"≥", "$\\ge$"},
    Replacement{"≤", "$\\le$"},
    Replacement{"−", "$-$"},
    Replacement{"√", "$\\surd$"},
    Replacement{"Φ⁻¹", "$\\Phi^{-1}$"},
    Replacement{"é", "\\'e"},
};

std::string escapedLatex(std::string_view text)
{
    std::string result;
    while (!text.empty()) {
        const Replacement* found = nullptr;
        for (const Replacement& replacement : replacements) {
            if (text.starts_with(replacement.text)) {
                found = &replacement;
            }
        }
        result += found != nullptr ? found->latex : text.substr(0, 1);
        text.remove_prefix(found != nullptr ? found->text.size() : 1);
    }
    return result;
}

std::string latexLine(const std::vector<std::string>& cells, bool isPublished)
{
    std::string text;
    for (const std::string& cell : cells) {
        text +=
            (text.empty() ? "  " : " & ") + (isPublished ? "\\textit{" + escapedLatex(cell) + "}" : escapedLatex(cell));
    }
    return text + " \\\\\n";
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

std::string toLatex(const core::ResultTable& table)
{
    std::string text = "\\begin{table}\n\\caption{" + escapedLatex(table.title) + "}\n\\label{tab:" + table.id +
                       "}\n\\centering\n\\resizebox{\\linewidth}{!}{%\n\\begin{tabular}{l" +
                       std::string(table.columns.size() - 1, 'r') + "}\n\\toprule\n";
    text += latexLine(table.columns, false) + "\\midrule\n";
    for (const core::ResultTable::Row& row : table.rows) {
        text += latexLine(row.cells, row.isPublished);
    }
    text += "\\bottomrule\n\\end{tabular}}\n";
    for (const std::string& note : table.notes) {
        text += "\n\\smallskip\\footnotesize " + escapedLatex(note) + "\n";
    }
    return text + "\\end{table}\n";
}

}   // namespace angiopose::io
