#include "core/evaluation/report/table_parts.h"
#include "core/evaluation/statistics/proportion.h"
#include "core/evaluation/statistics/signed_rank.h"
#include "core/support/format_number.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace angiopose::core {
namespace {

constexpr double sameMm = 1e-6;   // smaller differences are rounding errors
constexpr int minAnatomies = 6;   // minimum number for which winning on all anatomies is significant at 5 %

RunValue comparedValue(const Protocol& protocol)
{
    return protocol.success == SuccessCriterion::RayDistanceWithin2Mm ? &RunRecord::mrpdMm : &RunRecord::meanMm;
}

/// The quantile by which the trials of one tree are compared.
struct ComparedQuantile {
    const char* name;
    double fraction;
};
constexpr ComparedQuantile comparedMedian{"median", 0.5};
constexpr ComparedQuantile compared95th{"p95", 0.95};

bool comparesByAnatomy(const RunGroups& groups)
{
    return groups.anatomyCount() >= minAnatomies;
}

/// Returns the paired differences, first minus second: by anatomy if there are enough anatomies, otherwise by trial.
std::vector<double> differences(const RunGroups& groups, const RunGroup& ours, const RunGroup& theirs, double fraction)
{
    const RunValue value = comparedValue(groups.protocol());
    std::vector<double> result;
    if (comparesByAnatomy(groups)) {
        for (int anatomy = 0; anatomy < groups.anatomyCount(); ++anatomy) {
            result.push_back(ours.forAnatomy(anatomy).quantile(value, fraction) -
                             theirs.forAnatomy(anatomy).quantile(value, fraction));
        }
    } else {
        std::map<std::uint64_t, double> byTrial;
        for (const RunRecord* run : theirs.runs()) {
            byTrial[run->trial] = run->*value;
        }
        for (const RunRecord* run : ours.runs()) {
            if (const auto partner = byTrial.find(run->trial); partner != byTrial.end()) {
                result.push_back(run->*value - partner->second);
            }
        }
    }
    std::erase_if(result, [](double difference) { return std::isnan(difference); });
    std::replace_if(
        result.begin(), result.end(), [](double difference) { return std::abs(difference) < sameMm; }, 0.0);
    return result;
}

std::vector<ResultTable::Row> rowsOf(const RunGroups& groups, const Condition& condition,
                                     const ComparedQuantile& compared)
{
    std::vector<ResultTable::Row> rows;
    std::vector<double> pValues;
    for (std::size_t k = 1; k < groups.methods().size(); ++k) {
        const std::vector<double> paired =
            differences(groups, groups.groupOf(condition, groups.methods().front()),
                        groups.groupOf(condition, groups.methods()[k]), compared.fraction);
        if (paired.empty()) {
            continue;
        }
        const SignedRankTest test = signedRankTest(paired);
        pValues.push_back(test.pLess);
        rows.push_back({{condition.id, groups.methods()[k], comparesByAnatomy(groups) ? compared.name : "trial",
                         std::to_string(test.count), fixedText(test.rankSum, 1), significantText(test.pLess),
                         significantText(test.pTwoSided), "", fixedText(test.effectSize, 3),
                         significantText(hodgesLehmann(paired))},
                        false});
    }
    const std::vector<double> adjusted = adjustByHolm(pValues);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].cells[7] = significantText(adjusted[k]);
    }
    return rows;
}

bool isFlagged(const RunRecord& run)
{
    return run.trustworthy == 0.0;
}

ResultTable::Row rowOf(const std::string& method, const std::string& condition, const RunGroup& group,
                       SuccessCriterion criterion)
{
    const RunGroup gross = group.filter(isGrossFailureMm);
    const RunGroup failures = group.filter([criterion](const RunRecord& run) { return !isSuccess(criterion, run); });
    const RunGroup successes = group.filter([criterion](const RunRecord& run) { return isSuccess(criterion, run); });
    return {
        {method, condition, std::to_string(gross.count()), rateCell(gross, isFlagged), std::to_string(failures.count()),
         rateCell(failures, isFlagged), std::to_string(successes.count()), rateCell(successes, isFlagged)},
        false};
}

}   // namespace

std::vector<ResultTable> statisticsTables(const RunGroups& groups)
{
    const std::string_view protocol = groups.protocol().id;
    if (groups.methods().size() < 2 || protocol == "capture-range" || protocol == "trust") {
        return {};
    }
    ResultTable table;
    table.id = std::string(groups.protocol().id) + "-statistics";
    table.title = "Is " + groups.methods().front() + " better? Wilcoxon signed-rank test";
    table.columns = {"condition", "against", "of", "N", "W", "p one-sided", "p two-sided", "p Holm", "r", "shift mm"};
    for (const Condition& condition : groups.conditions()) {
        for (ResultTable::Row& row : rowsOf(groups, condition, comparedMedian)) {
            table.rows.push_back(std::move(row));
        }
    }
    const bool isByAnatomy = comparesByAnatomy(groups);
    for (std::size_t k = 0; isByAnatomy && k < groups.conditions().size(); ++k) {
        for (ResultTable::Row& row : rowsOf(groups, groups.conditions()[k], compared95th)) {
            table.rows.push_back(std::move(row));
        }
    }
    table.notes = {
        std::string("Paired differences (") + groups.methods().front() + " minus the other) of " +
            (comparedValue(groups.protocol()) == &RunRecord::mrpdMm ? "mRPD" : "PR") + ", " +
            (isByAnatomy ? "of the medians, and of the 95th percentiles, over each tree's trials" : "of each trial") +
            "; differences below one nanometer count as zero; exact up to 50 pairs. W: rank sum of the differences "
            "where " +
            groups.methods().front() + " is worse.",
        "p Holm: the one-sided p adjusted for all comparisons of the same condition and percentile; r = Φ⁻¹(1 − p)/√N, "
        "at most 1; shift: "
        "Hodges–Lehmann estimate, negative where " +
            groups.methods().front() + " is better."};
    return {table};
}

std::vector<ResultTable> confidenceTables(const RunGroups& groups)
{
    ResultTable table;
    table.id = "trust";
    table.title = "Does the method detect its failures?";
    table.columns = {"method",    "images",        "gross", "of them flagged %", "failures", "of them flagged %",
                     "successes", "false alarms %"};
    for (const std::string& method : groups.methods()) {
        RunGroup all;
        for (const Condition& condition : groups.conditions()) {
            const RunGroup& group = groups.groupOf(condition, method);
            table.rows.push_back(rowOf(method, condition.title, group, groups.protocol().success));
            for (const RunRecord* run : group.runs()) {
                all.add(*run);
            }
        }
        table.rows.push_back(rowOf(method, "all of them", all, groups.protocol().success));
    }
    table.notes = {
        "gross: mean projection distance above 5 mm; failures: mRPD of 2 mm and more; successes: all others. flagged, "
        "false alarms: the method does not rate the pose reliable. Shares with their 95 % intervals from resampling "
        "trees with all their trials.",
        "Another patient's tree and a mirrored image have no correct pose: every result is a gross failure."};
    return {table};
}

}   // namespace angiopose::core
