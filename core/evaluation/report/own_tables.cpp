#include "core/evaluation/report/table_parts.h"
#include "core/support/format_number.h"

#include <cmath>

namespace angiopose::core {
namespace {

std::string quantilesCell(const RunGroup& group, RunValue value, int decimals)
{
    return fixedText(group.median(value), decimals) + " / " + fixedText(group.quantile(value, 0.95), decimals);
}

std::vector<std::string> cellsOf(const std::string& method, const RunGroup& group)
{
    const auto isBelow = [](double limitMm) {
        return [limitMm](const RunRecord& run) { return run.mrpdMm < limitMm; };
    };
    const auto isFlagged = [](const RunRecord& run) { return run.trustworthy == 0.0; };
    const RunGroup judging = group.where([](const RunRecord& run) { return !std::isnan(run.trustworthy); });
    const RunGroup failures = judging.where([](const RunRecord& run) { return !(run.mrpdMm < successfulMrpdMm); });
    const RunGroup successes = judging.where(isBelow(successfulMrpdMm));
    return {method,
            std::to_string(group.count()),
            std::to_string(group.countIf([](const RunRecord& run) { return run.hasResult == 0.0; })),
            quantilesCell(group, &RunRecord::meanPx, 2),
            quantilesCell(group, &RunRecord::meanMm, 2),
            quantilesCell(group, &RunRecord::mrpdMm, 2),
            quantilesCell(group, &RunRecord::mtreMm, 2),
            quantilesCell(group, &RunRecord::angleDeg, 2),
            shareCell(group, isBelow(1.0)),
            shareCell(group, isBelow(successfulMrpdMm)),
            shareCell(group, isGrossMm),
            percentCell(failures.countIf(isFlagged), failures.count()),
            percentCell(successes.countIf(isFlagged), successes.count())};
}

ResultTable ownTable(const RunGroups& groups, const Condition& condition)
{
    ResultTable table;
    table.id = "own-" + condition.id;
    table.title = "Own cases: " + condition.title;
    table.columns = {"method",      "cases",   "without result", "PR px",    "PR mm",   "mRPD mm",
                     "mTRE mm",     "angle °", "< 1 mm %",       "< 2 mm %", "gross %", "failures flagged",
                     "false alarms"};
    for (const std::string& method : groups.methods()) {
        if (groups.of(condition, method).count() > 0) {
            table.rows.push_back({cellsOf(method, groups.of(condition, method)), false});
        }
    }
    table.notes = {
        "Median / 95th percentile over the cases; without a result the start pose counts. Against a reference pose PR "
        "is the distance of projected tree points to their true partners, mRPD the distance of the targets to the rays "
        "of "
        "the found ones, mTRE that between both; targets are the landmarks, or the tree's points and the corners of "
        "their box. Against pairs of points alone PR is the distance to the pixel, mRPD that to its ray.",
        "< 1 mm, < 2 mm: shares by mRPD; gross: PR above 5 mm; with their 95 % intervals, patients drawn anew with all "
        "their cases. failures flagged: share of those with mRPD of 2 mm and more that the method does not call "
        "trustworthy; false alarms: share of the others. A pose that was found elsewhere says nothing of its trust.",
        "Where the list says where bent vessels lay (column bent), PR, mRPD and mTRE are those of the tree as a result "
        "shows it, bent or not; else those of its rigid pose."};
    return table;
}

}   // namespace

std::vector<ResultTable> ownTables(const RunGroups& groups)
{
    std::vector<ResultTable> tables;
    for (const Condition& condition : groups.conditions()) {
        tables.push_back(ownTable(groups, condition));
    }
    return tables;
}

}   // namespace angiopose::core
