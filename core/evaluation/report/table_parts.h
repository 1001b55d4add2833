#pragma once

#include "core/evaluation/report/result_table.h"
#include "core/evaluation/report/run_groups.h"

#include <string>
#include <vector>

// The pieces that tablesOf() puts together, and what their layouts share.

namespace angiopose::core {

std::vector<ResultTable> toyTables(const RunGroups& groups);
std::vector<ResultTable> simulationTables(const RunGroups& groups);
std::vector<ResultTable> asPublishedTables(const RunGroups& groups);   ///< simulation in the paper's own measure
std::vector<ResultTable> robustnessTables(const RunGroups& groups);
std::vector<ResultTable> clinicalTables(const RunGroups& groups);
std::vector<ResultTable> captureRangeTables(const RunGroups& groups);
std::vector<ResultTable> trustTables(const RunGroups& groups);
std::vector<ResultTable> ownTables(const RunGroups& groups);
std::vector<ResultTable> statisticsTables(const RunGroups& groups);   ///< paired comparisons, any protocol
std::vector<ResultTable> ablationTables(const RunGroups& groups);   ///< where settings of DynaWeightPnP were varied
std::vector<ResultTable> timeTables(const RunGroups& groups);

/// "dynaweight" of "dynaweight:seed_mean".
std::string methodIdOf(const std::string& label);

/// True for the last label of its method: the published row comes below it.
bool isLastOfItsMethod(const std::vector<std::string>& labels, std::size_t index);

/// "12.5 [10.1, 15.2]": the share of the runs for which `holds`, in %, and its 95 % interval, for which trees are drawn
/// anew with all their trials (clusteredInterval); "–" of nothing.
std::string shareCell(const RunGroup& group, const std::function<bool(const RunRecord&)>& holds);

/// "95 %", "–" of nothing.
std::string percentCell(int part, int whole);

/// Median size of the centroid's depth error.
double medianDepthMm(const RunGroup& group);

/// A row of the paper's figures: its label, then the cells, filled up with dashes to the table's width.
ResultTable::Row publishedRow(const ResultTable& table, const std::string& label, std::vector<std::string> cells);

}   // namespace angiopose::core