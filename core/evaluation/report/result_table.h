#pragma once

#include "core/evaluation/trial/run_record.h"

#include <string>
#include <vector>

namespace angiopose::core {

/// A table for the report; io writes it as Markdown and LaTeX.
struct ResultTable {
    struct Row {
        std::vector<std::string> cells;   ///< one per column
        bool isPublished = false;   ///< whether the row holds the paper's values, below our own of the same method
    };
    std::string id;   ///< file name without extension
    std::string title;
    std::vector<std::string> columns;
    std::vector<Row> rows;
    std::vector<std::string> notes;   ///< one sentence each
};

/// Returns every table that the runs allow: errors by condition in the paper's layout, statistics, ablation, times.
std::vector<ResultTable> makeTables(const RunSet& runs);

}   // namespace angiopose::core
