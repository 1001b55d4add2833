#pragma once

#include "core/evaluation/report/result_table.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Title, table and notes as Markdown (GitHub's tables); published rows in italics.
std::string toMarkdown(const core::ResultTable& table);

/// The same as a LaTeX table for \input (packages booktabs and graphicx); first column left, numbers right.
std::string toLatex(const core::ResultTable& table);

/// The same for a terminal, columns aligned.
std::string toPlainText(const core::ResultTable& table);

}   // namespace angiopose::io