#include "core/evaluation/report/published_results.h"
#include "core/evaluation/report/table_parts.h"
#include "core/support/format_number.h"

#include <cmath>

namespace angiopose::core {
namespace {

std::string successCell(const RunGroup& group, double limitMm)
{
    return rateCell(group, [limitMm](const RunRecord& run) { return run.mrpdMm < limitMm; });
}

std::vector<std::string> clinicalCells(const std::string& method, const RunGroup& group)
{
    const auto isFlagged = [](const RunRecord& run) { return run.trustworthy == 0.0; };
    const RunGroup gross = group.filter(isGrossFailureMm);
    const RunGroup failures = group.filter([](const RunRecord& run) { return !(run.mrpdMm < successfulMrpdMm); });
    const RunGroup successes = group.filter([](const RunRecord& run) { return run.mrpdMm < successfulMrpdMm; });
    return {method,
            rateCell(group, isGrossFailureMm),
            fixedText(group.median(&RunRecord::meanMm), 2),
            fixedText(group.quantile(&RunRecord::meanMm, 0.75), 2),
            fixedText(group.quantile(&RunRecord::meanMm, 0.95), 2),
            successCell(group, successfulMrpdMm),
            successCell(group, 1.0),
            successCell(group, 5.0),
            fixedText(group.median(&RunRecord::mrpdMm), 2),
            fixedText(group.median(&RunRecord::mtreMm), 1),
            percentCell(gross.countIf(isFlagged), gross.count()),
            percentCell(failures.countIf(isFlagged), failures.count()),
            percentCell(successes.countIf(isFlagged), successes.count()),
            significantText(group.mean(&RunRecord::nees)),
            fixedText(successes.mean(&RunRecord::nees), 1)};
}

/// Returns a note on how many pairs of methods have medians in the order published in the paper.
std::string orderNote(const RunGroups& groups, const Condition& condition)
{
    std::vector<std::pair<double, double>> medians;   // (ours, published)
    for (const std::string& method : groups.methods()) {
        const RunGroup& group = groups.groupOf(condition, method);
        if (const auto published = publishedInVivo(method); published && group.count() > 0) {
            medians.emplace_back(group.median(&RunRecord::meanMm), published->medianMm);
        }
    }
    int pairs = 0;
    int concordant = 0;
    for (std::size_t a = 0; a < medians.size(); ++a) {
        for (std::size_t b = a + 1; b < medians.size(); ++b) {
            ++pairs;
            concordant += (medians[a].first < medians[b].first) == (medians[a].second < medians[b].second) ? 1 : 0;
        }
    }
    return pairs == 0 ? ""
                      : " By the median, " + std::to_string(concordant) + " of " + std::to_string(pairs) +
                            " pairs of methods are in the published order.";
}

ResultTable clinicalTable(const RunGroups& groups, const Condition& condition)
{
    ResultTable table;
    table.id = "clinical-" + condition.id;
    table.title = "Clinical protocol: " + condition.title;
    table.columns = {"method",       "GFR %",    "median mm",      "p75 mm",  "p95 mm",        "mRPD < 2 mm %",
                     "< 1 mm %",     "< 5 mm %", "mRPD mm",        "mTRE mm", "gross flagged", "failures flagged",
                     "false alarms", "NEES",     "NEES, successes"};
    for (std::size_t k = 0; k < groups.methods().size(); ++k) {
        const std::string& method = groups.methods()[k];
        if (groups.groupOf(condition, method).count() == 0) {
            continue;
        }
        table.rows.push_back({clinicalCells(method, groups.groupOf(condition, method)), false});
        const auto published = publishedInVivo(methodIdOf(method));
        if (published && isLastOfMethod(groups.methods(), k)) {
            table.rows.push_back(publishedRow(table, methodIdOf(method) + " in vivo",
                                              {fixedText(published->grossPercent, 0), fixedText(published->medianMm, 2),
                                               fixedText(published->p75Mm, 2), fixedText(published->p95Mm, 2)}));
        }
    }
    table.notes = {
        "Distances to the true partners under the best rigid pose (PR), mm; GFR: PR above 5 mm; mRPD: mean distance of "
        "the true points to the rays of the registered ones. Shares with their 95 % intervals from resampling trees "
        "with all their trials.",
        "gross flagged, failures flagged: share of those with PR above 5 mm, and with mRPD of 2 mm and more, that the "
        "method does not rate reliable; false alarms: share of the successes that it does not rate reliable. NEES: "
        "mean over all runs, and over the successes; a consistent covariance gives 6.",
        "The published figures come from 278 patient images that are not public, and their GFR is inconsistent with "
        "their quantiles; ours come from synthetic images with known poses." +
            orderNote(groups, condition)};
    return table;
}

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
    const RunGroup judging = group.filter([](const RunRecord& run) { return !std::isnan(run.trustworthy); });
    const RunGroup failures = judging.filter([](const RunRecord& run) { return !(run.mrpdMm < successfulMrpdMm); });
    const RunGroup successes = judging.filter(isBelow(successfulMrpdMm));
    return {method,
            std::to_string(group.count()),
            std::to_string(group.countIf([](const RunRecord& run) { return run.hasResult == 0.0; })),
            quantilesCell(group, &RunRecord::meanPx, 2),
            quantilesCell(group, &RunRecord::meanMm, 2),
            quantilesCell(group, &RunRecord::mrpdMm, 2),
            quantilesCell(group, &RunRecord::mtreMm, 2),
            quantilesCell(group, &RunRecord::angleDeg, 2),
            rateCell(group, isBelow(1.0)),
            rateCell(group, isBelow(successfulMrpdMm)),
            rateCell(group, isGrossFailureMm),
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
        if (groups.groupOf(condition, method).count() > 0) {
            table.rows.push_back({cellsOf(method, groups.groupOf(condition, method)), false});
        }
    }
    table.notes = {
        "Median / 95th percentile over the cases; without a result the initial pose counts. Against a reference pose, "
        "PR is the distance of projected tree points to their true partners, mRPD the distance of the targets to the "
        "rays of the registered ones, mTRE the distance between both; targets are the landmarks, or the tree's points "
        "and the corners of their bounding box. Against pairs of points alone, PR is the distance to the pixel, mRPD "
        "the distance to its ray.",
        "< 1 mm, < 2 mm: shares by mRPD; gross: PR above 5 mm; with their 95 % intervals from resampling patients with "
        "all their cases. failures flagged: share of those with mRPD of 2 mm and more that the method does not rate "
        "reliable; false alarms: share of the others. Poses from other programs carry no reliability rating.",
        "If the list gives the true position of deformed vessels (column bent), PR, mRPD and mTRE are those of the "
        "tree as the result shows it, deformed or not; otherwise those of its rigid pose."};
    return table;
}

}   // namespace

std::vector<ResultTable> clinicalTables(const RunGroups& groups)
{
    std::vector<ResultTable> tables;
    for (const Condition& condition : groups.conditions()) {
        tables.push_back(clinicalTable(groups, condition));
    }
    return tables;
}

std::vector<ResultTable> ownTables(const RunGroups& groups)
{
    std::vector<ResultTable> tables;
    for (const Condition& condition : groups.conditions()) {
        tables.push_back(ownTable(groups, condition));
    }
    return tables;
}

}   // namespace angiopose::core
