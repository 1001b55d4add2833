#include "core/evaluation/report/published_results.h"
#include "core/evaluation/report/table_parts.h"
#include "core/support/format_number.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

const std::string yardstick = "dt-icp";   // machines compare through it alone

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

std::string yardstickRatio(const RunGroups& groups, const Condition& condition, double ms)
{
    const double yardstickMs = groups.of(condition, yardstick).median(&RunRecord::processorMs);
    return std::isnan(yardstickMs) ? "–" : fixedText(ms / yardstickMs, 2);
}

}   // namespace

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
            const RunGroup& group = groups.of(condition, method);
            if (group.count() == 0) {
                continue;
            }
            const double medianMs = group.median(&RunRecord::processorMs);
            table.rows.push_back(
                {{condition.id, method, fixedText(medianMs, 2),
                  fixedText(group.quantile(&RunRecord::processorMs, 0.95), 2),
                  fixedText(group.median(&RunRecord::totalMs), 2), fixedText(group.median(&RunRecord::targetMs), 2),
                  fixedText(group.median(&RunRecord::searchMs), 2), fixedText(group.median(&RunRecord::solveMs), 2),
                  fixedText(group.median(&RunRecord::traceMs), 1), yardstickRatio(groups, condition, medianMs)},
                 false});
            const auto published = publishedMs(condition, methodIdOf(method));
            if (published && isLastOfItsMethod(groups.methods(), k)) {
                std::vector<std::string> cells{condition.id, methodIdOf(method) + ", published",
                                               fixedText(*published, 1)};
                cells.resize(table.columns.size(), "–");
                table.rows.push_back({std::move(cells), true});
            }
        }
    }
    table.notes = {
        "Medians over the trials. Processor time of the registering thread, target map, search and judging "
        "included. Target, search and solve are wall times: these say little with several --threads or on a busy "
        "machine. Published times come from another "
        "machine: compare through dt-icp only."};
    return {table};
}

}   // namespace angiopose::core