#include "io/evaluation/table_text.h"

#include <array>
#include <string_view>

namespace angiopose::io {
namespace {

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