#pragma once

#include "core/evaluation/report/plot.h"
#include "core/evaluation/report/result_table.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// All tables and plots as one self-contained page: no scripts, no external resources, prints as displayed.
std::string htmlReport(const std::string& title, const std::vector<core::ResultTable>& tables,
                       const std::vector<core::Plot>& plots);

}   // namespace angiopose::io
