#pragma once

#include "core/evaluation/report/result_table.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Formats the title, the table and its notes as Markdown (GitHub tables); published rows are in italics.
std::string toMarkdown(const core::ResultTable& table);

/// Formats a table as LaTeX for \input (packages booktabs, graphicx); first column left-aligned, numbers right-aligned.
std::string toLatex(const core::ResultTable& table);

/// Formats the table as plain text with aligned columns, for a terminal.
std::string toPlainText(const core::ResultTable& table);

}   // namespace angiopose::io
