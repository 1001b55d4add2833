#include "core/evaluation/report/table_parts.h"
#include "core/support/format_number.h"

namespace angiopose::core {
namespace {

constexpr double demandedRate = 0.95;

std::vector<Condition> binsOf(const RunGroups& groups, const std::string& target)
{
    std::vector<Condition> bins;
    for (const Condition& condition : groups.conditions()) {
        if (condition.id.starts_with(target + "-")) {
            bins.push_back(condition);
        }
    }
    return bins;
}

/// "5-6" of "clean-5-6".
std::string rangeOf(const Condition& bin, const std::string& target)
{
    return bin.id.substr(target.size() + 1);
}

int successesOf(const RunGroups& groups, const RunGroup& group)
{
    return group.countIf([&](const RunRecord& run) { return isSuccess(groups.protocol().success, run); });
}

/// Upper edge of the last bin such that this and all lower ones succeed often enough; "0" when the first does not.
std::string captureRangeCell(const RunGroups& groups, const std::vector<Condition>& bins, const std::string& target,
                             const std::string& method)
{
    std::string reached = "0";
    for (const Condition& bin : bins) {
        const RunGroup& group = groups.of(bin, method);
        if (group.count() == 0 || successesOf(groups, group) < demandedRate * group.count()) {
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
        ResultTable::Row row{{rangeOf(bin, target)}, false};
        row.cells.front().replace(row.cells.front().find('-'), 1, "–");
        for (const std::string& method : groups.methods()) {
            const RunGroup& group = groups.of(bin, method);
            row.cells.push_back(shareCell(successesOf(groups, group), group.count()));
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {
        "Success: mRPD below 2 mm, with the rate's 95 % Wilson interval. Capture range: upper edge of the "
        "last bin such that this and all lower ones succeed in at least 95 % of the starts."};
    return table;
}

}   // namespace

std::vector<ResultTable> captureRangeTables(const RunGroups& groups)
{
    std::vector<ResultTable> tables;
    for (const auto& [target, title] :
         {std::pair<std::string, std::string>{"clean", "curves sampled anew"}, {"degraded", "degraded target"}}) {
        if (!binsOf(groups, target).empty()) {
            tables.push_back(tableOf(groups, target, title));
        }
    }
    return tables;
}

}   // namespace angiopose::core