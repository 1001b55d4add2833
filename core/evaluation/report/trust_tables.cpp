#include "core/evaluation/report/table_parts.h"

namespace angiopose::core {
namespace {

bool isFlagged(const RunRecord& run)
{
    return run.trustworthy == 0.0;
}

ResultTable::Row rowOf(const std::string& method, const std::string& condition, const RunGroup& group, Success rule)
{
    const RunGroup gross = group.where(isGrossMm);
    const RunGroup failures = group.where([rule](const RunRecord& run) { return !isSuccess(rule, run); });
    const RunGroup successes = group.where([rule](const RunRecord& run) { return isSuccess(rule, run); });
    return {{method, condition, std::to_string(gross.count()), shareCell(gross, isFlagged),
             std::to_string(failures.count()), shareCell(failures, isFlagged), std::to_string(successes.count()),
             shareCell(successes, isFlagged)},
            false};
}

}   // namespace

std::vector<ResultTable> trustTables(const RunGroups& groups)
{
    ResultTable table;
    table.id = "trust";
    table.title = "Does the method know when it fails?";
    table.columns = {"method",    "images",        "gross", "of them flagged %", "failures", "of them flagged %",
                     "successes", "false alarms %"};
    for (const std::string& method : groups.methods()) {
        RunGroup all;
        for (const Condition& condition : groups.conditions()) {
            const RunGroup& group = groups.of(condition, method);
            table.rows.push_back(rowOf(method, condition.title, group, groups.protocol().success));
            for (const RunRecord* run : group.runs()) {
                all.add(*run);
            }
        }
        table.rows.push_back(rowOf(method, "all of them", all, groups.protocol().success));
    }
    table.notes = {
        "gross: mean projection distance above 5 mm; failures: mRPD of 2 mm and more; successes: all others. flagged, "
        "false alarms: the method does not call the pose trustworthy. Shares with their 95 % intervals, trees drawn "
        "anew with all their trials.",
        "Another patient's tree and a mirrored image have no right pose: every answer is a gross failure."};
    return {table};
}

}   // namespace angiopose::core