#pragma once

#include "core/evaluation/report/plot.h"
#include "core/evaluation/report/result_table.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Returns all tables and plots as one self-contained page without scripts that prints as displayed.
std::string htmlReport(const std::string& title, const std::vector<core::ResultTable>& tables,
                       const std::vector<core::Plot>& plots);

}   // namespace angiopose::io
