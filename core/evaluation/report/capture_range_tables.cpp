#include "core/evaluation/report/table_parts.h"
#include "core/support/format_number.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double requiredRate = 0.95;

/// Returns all bins of the protocol for one kind of target, including those that were not run.
std::vector<Condition> binsOf(const RunGroups& groups, const std::string& target)
{
    std::vector<Condition> bins;
    for (const Condition& condition : groups.protocol().conditions) {
        if (condition.id.starts_with(target + "-")) {
            bins.push_back(condition);
        }
    }
    return bins;
}

/// Returns the mTRE range of a bin: "5-6" for "clean-5-6".
std::string rangeOf(const Condition& bin, const std::string& target)
{
    return bin.id.substr(target.size() + 1);
}

int successesOf(const RunGroups& groups, const RunGroup& group)
{
    return group.countIf([&](const RunRecord& run) { return isSuccess(groups.protocol().success, run); });
}

bool hasRun(const RunGroups& groups, const Condition& bin)
{
    return std::ranges::any_of(groups.methods(),
                               [&](const std::string& method) { return groups.groupOf(bin, method).count() > 0; });
}

/// Returns a note such as "Not run: 3-4, 60-65 mm." about the bins of a table; empty if all were run.
std::string missingNote(const RunGroups& groups, const std::vector<Condition>& bins, const std::string& target)
{
    std::string missing;
    for (const Condition& bin : bins) {
        if (!hasRun(groups, bin)) {
            missing += (missing.empty() ? "Not run: " : ", ") + rangeOf(bin, target);
        }
    }
    return missing.empty() ? "" : missing + " mm.";
}

/// Returns the upper edge of the last bin up to which every bin reaches `requiredRate`: "0" if the first bin fails,
/// with a leading "≥" if the next bin was not run.
std::string captureRangeCell(const RunGroups& groups, const std::vector<Condition>& bins, const std::string& target,
                             const std::string& method)
{
    std::string reached = "0";
    for (const Condition& bin : bins) {
        const RunGroup& group = groups.groupOf(bin, method);
        if (group.count() == 0) {
            return "≥ " + reached;
        }
        if (successesOf(groups, group) < requiredRate * group.count()) {
            return reached;
        }
        const std::string range = rangeOf(bin, target);
        reached = range.substr(range.find('-') + 1);
    }
    return "≥ " + reached;
}

ResultTable tableOf(const RunGroups& groups, const std::string& target, const std::string& title)
{
    const std::vector<Condition> bins = binsOf(groups, target);
    ResultTable table{
        "capture-range-" + target, "Capture range, " + title + ": success rate %", {"start mTRE mm"}, {}, {}};
    table.columns.insert(table.columns.end(), groups.methods().begin(), groups.methods().end());
    ResultTable::Row ranges{{"capture range mm"}, false};
    for (const std::string& method : groups.methods()) {
        ranges.cells.push_back(captureRangeCell(groups, bins, target, method));
    }
    table.rows.push_back(std::move(ranges));
    for (const Condition& bin : bins) {
        if (!hasRun(groups, bin)) {
            continue;
        }
        ResultTable::Row row{{rangeOf(bin, target)}, false};
        row.cells.front().replace(row.cells.front().find('-'), 1, "–");
        for (const std::string& method : groups.methods()) {
            const RunGroup& group = groups.groupOf(bin, method);
            row.cells.push_back(
                rateCell(group, [&](const RunRecord& run) { return isSuccess(groups.protocol().success, run); }));
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {
        "Success: mRPD below 2 mm, with the 95 % interval of the rate from resampling trees with all their trials. "
        "Capture range: upper edge of the last bin for which it and all lower bins succeed in at least 95 % of the "
        "trials; a lower bound if the next bin was not run."};
    if (const std::string missing = missingNote(groups, bins, target); !missing.empty()) {
        table.notes.push_back(missing);
    }
    return table;
}

}   // namespace

std::vector<ResultTable> captureRangeTables(const RunGroups& groups)
{
    std::vector<ResultTable> tables;
    for (const auto& [target, title] :
         {std::pair<std::string, std::string>{"clean", "resampled curves"}, {"degraded", "degraded target"}}) {
        const std::vector<Condition> bins = binsOf(groups, target);
        if (std::ranges::any_of(bins, [&](const Condition& bin) { return hasRun(groups, bin); })) {
            tables.push_back(tableOf(groups, target, title));
        }
    }
    return tables;
}

}   // namespace angiopose::core
