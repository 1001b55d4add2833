#pragma once

#include "core/evaluation/report/result_table.h"
#include "core/evaluation/report/run_groups.h"

#include <string>
#include <vector>

// Table groups from which tablesOf() builds the report, and helpers shared by their layouts.

namespace angiopose::core {

std::vector<ResultTable> toyTables(const RunGroups& groups);
std::vector<ResultTable> simulationTables(const RunGroups& groups);
std::vector<ResultTable> asPublishedTables(const RunGroups& groups);   ///< simulation results, measured as in the paper
std::vector<ResultTable> robustnessTables(const RunGroups& groups);
std::vector<ResultTable> clinicalTables(const RunGroups& groups);
std::vector<ResultTable> captureRangeTables(const RunGroups& groups);
std::vector<ResultTable> confidenceTables(const RunGroups& groups);
std::vector<ResultTable> ownTables(const RunGroups& groups);
std::vector<ResultTable> statisticsTables(const RunGroups& groups);   ///< paired comparisons, for any protocol
std::vector<ResultTable> ablationTables(const RunGroups& groups);   ///< if the settings of DynaWeightPnP were varied
std::vector<ResultTable> timeTables(const RunGroups& groups);

/// Returns the method id of a label, for example "dynaweight" for "dynaweight:seed_mean".
std::string methodIdOf(const std::string& label);

/// Whether the label is the last one of its method; the published row is inserted after it.
bool isLastOfMethod(const std::vector<std::string>& labels, std::size_t index);

/// Returns text such as "12.5 [10.1, 15.2]": the percentage of the runs that satisfy `predicate` and its 95 % interval,
/// bootstrapped over trees with all their trials (clusteredInterval); "–" if there are no runs.
std::string rateCell(const RunGroup& group, const std::function<bool(const RunRecord&)>& predicate);

/// Returns `part` as a percentage of `whole`, such as "95 %"; "–" if `whole` is zero.
std::string percentCell(int part, int whole);

/// Returns the median absolute depth error of the centroid.
double medianDepthMm(const RunGroup& group);

/// Returns a row with the paper's values: the label, then the cells, padded with dashes to the table's width.
ResultTable::Row publishedRow(const ResultTable& table, const std::string& label, std::vector<std::string> cells);

}   // namespace angiopose::core
