#pragma once

#include "core/evaluation/report/result_table.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Title, table and notes as Markdown (GitHub tables); published rows in italics.
std::string toMarkdown(const core::ResultTable& table);

/// The table as LaTeX for \input (packages booktabs and graphicx); first column left-aligned, numbers right-aligned.
std::string toLatex(const core::ResultTable& table);

/// The table as plain text for a terminal, with aligned columns.
std::string toPlainText(const core::ResultTable& table);

}   // namespace angiopose::io