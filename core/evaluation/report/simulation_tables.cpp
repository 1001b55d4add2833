#include "core/evaluation/report/published_results.h"
#include "core/evaluation/report/table_parts.h"
#include "core/support/format_number.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// Returns the ratio of the root mean square error to the Cramér–Rao bound, over the runs without gross failure.
std::string boundRatioCell(const RunGroup& group)
{
    double squares = 0.0;
    double boundSquares = 0.0;
    for (const RunRecord* run : group.runs()) {
        if (!isGrossFailurePx(*run) && !std::isnan(run->boundRmsPx)) {
            squares += run->rmsPx * run->rmsPx;
            boundSquares += run->boundRmsPx * run->boundRmsPx;
        }
    }
    return boundSquares > 0.0 ? fixedText(std::sqrt(squares / boundSquares), 2) : "–";
}

std::vector<std::string> simulationCells(const std::string& method, const RunGroup& group)
{
    const RunGroup good = group.filter([](const RunRecord& run) { return !isGrossFailurePx(run); });
    const RunGroup gross = group.filter(isGrossFailurePx);
    const auto flagged = [](const RunRecord& run) { return run.trustworthy == 0.0; };
    return {method,
            rateCell(group, isGrossFailurePx),
            significantText(group.mean(&RunRecord::meanMm)),
            significantText(group.quantile(&RunRecord::meanMm, 0.75)),
            significantText(group.quantile(&RunRecord::meanMm, 0.95)),
            significantText(good.mean(&RunRecord::meanMm)),
            significantText(group.median(&RunRecord::meanPx)),
            significantText(group.quantile(&RunRecord::meanPx, 0.95)),
            fixedText(100.0 * group.countIf(isGrossFailureMm) / group.count(), 1),
            fixedText(100.0 * group.mean(&RunRecord::fractionAbove5Px), 1),
            significantText(group.median(&RunRecord::angleDeg)),
            significantText(group.median(&RunRecord::centroidInPlaneMm)),
            significantText(medianDepthMm(group)),
            percentCell(gross.countIf(flagged), gross.count()),
            percentCell(good.countIf(flagged), good.count()),
            significantText(group.mean(&RunRecord::nees)),
            fixedText(good.mean(&RunRecord::nees), 1),
            boundRatioCell(group)};
}

/// Returns a note with the mean error of the initial poses.
std::string startNote(const RunGroups& groups, const Condition& condition)
{
    const auto ran = std::find_if(groups.methods().begin(), groups.methods().end(), [&](const std::string& method) {
        return groups.groupOf(condition, method).count() > 0;
    });
    if (ran == groups.methods().end()) {
        return {};
    }
    return "Initial poses are " + fixedText(groups.groupOf(condition, *ran).mean(&RunRecord::startMeanPx), 0) +
           " px off on average.";
}

ResultTable simulationTable(const RunGroups& groups, const Condition& condition)
{
    ResultTable table;
    table.id = "simulation-" + condition.id;
    table.title = "Simulation: " + condition.title;
    table.columns = {
        "method",       "GFR %",      "mean mm",         "p75 mm",  "p95 mm",      "mean mm, not gross", "median px",
        "p95 px",       "GFR 5 mm %", "points > 5 px %", "angle °", "in plane mm", "depth mm",           "flagged",
        "false alarms", "NEES",       "NEES, not gross", "PR / CRB"};
    for (const std::string& method : groups.methods()) {
        if (groups.groupOf(condition, method).count() == 0) {
            continue;
        }
        table.rows.push_back({simulationCells(method, groups.groupOf(condition, method)), false});
    }
    table.notes = {
        "Distances are means over the tree's points to their true partners (PR), summarized over registrations; mm at "
        "the depth of the tree's centroid.",
        "GFR: share of registrations with PR above 5 px (first) or 5 mm, with its 95 % interval from resampling trees "
        "with all their trials; flagged: share of the gross failures not rated reliable; false alarms: share of the "
        "others.",
        "angle, in plane and depth are medians; NEES is the mean of the normalized squared errors of all runs, and of "
        "those that are not gross failures (a consistent covariance gives 6); PR / CRB is the ratio of their rms PR to "
        "the Cramér–Rao bound for the simulated noise.",
        startNote(groups, condition)};
    return table;
}

const std::string referenceMethod = "dt-icp";   // reference method for comparing times between machines

std::optional<double> publishedMs(const Condition& condition, const std::string& methodId)
{
    double ms = unknownMeasure;
    if (const auto simulated = publishedSimulation(methodId); simulated && condition.id == "exact-cam-2-5") {
        ms = simulated->timeMs;
    }
    if (const auto inVivo = publishedInVivo(methodId); inVivo && condition.id == "nonrigid-1") {
        ms = inVivo->timeMs;
    }
    return std::isnan(ms) ? std::nullopt : std::optional(ms);
}

std::string referenceTimeRatio(const RunGroups& groups, const Condition& condition, double ms)
{
    const double referenceMs = groups.groupOf(condition, referenceMethod).median(&RunRecord::processorMs);
    return std::isnan(referenceMs) ? "–" : fixedText(ms / referenceMs, 2);
}

}   // namespace

std::vector<ResultTable> simulationTables(const RunGroups& groups)
{
    std::vector<ResultTable> tables;
    for (const Condition& condition : groups.conditions()) {
        tables.push_back(simulationTable(groups, condition));
    }
    for (ResultTable& table : asPublishedTables(groups)) {
        tables.push_back(std::move(table));
    }
    return tables;
}

std::vector<ResultTable> timeTables(const RunGroups& groups)
{
    ResultTable table;
    table.id = std::string(groups.protocol().id) + "-times";
    table.title = "Time of one registration, ms";
    table.columns = {"condition", "method", "processor median", "processor p95", "wall median", "target",
                     "search",    "solve",  "tracing",          "× dt-icp"};
    for (const Condition& condition : groups.conditions()) {
        for (std::size_t k = 0; k < groups.methods().size(); ++k) {
            const std::string& method = groups.methods()[k];
            const RunGroup& group = groups.groupOf(condition, method);
            if (group.count() == 0) {
                continue;
            }
            const double medianMs = group.median(&RunRecord::processorMs);
            table.rows.push_back(
                {{condition.id, method, fixedText(medianMs, 2),
                  fixedText(group.quantile(&RunRecord::processorMs, 0.95), 2),
                  fixedText(group.median(&RunRecord::totalMs), 2), fixedText(group.median(&RunRecord::targetMs), 2),
                  fixedText(group.median(&RunRecord::searchMs), 2), fixedText(group.median(&RunRecord::solveMs), 2),
                  fixedText(group.median(&RunRecord::traceMs), 1), referenceTimeRatio(groups, condition, medianMs)},
                 false});
            const auto published = publishedMs(condition, methodIdOf(method));
            if (published && isLastOfMethod(groups.methods(), k)) {
                std::vector<std::string> cells{condition.id, methodIdOf(method) + ", published",
                                               fixedText(*published, 1)};
                cells.resize(table.columns.size(), "–");
                table.rows.push_back({std::move(cells), true});
            }
        }
    }
    table.notes = {
        "Medians over the trials. Processor time is that of the registering thread and includes target map, search and "
        "evaluation. Target, search and solve are wall times, which mean little with several --threads or on a busy "
        "machine. Published times come from another machine: compare them only relative to dt-icp."};
    return {table};
}

}   // namespace angiopose::core
