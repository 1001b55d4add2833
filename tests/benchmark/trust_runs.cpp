#include "tests/benchmark/trust_runs.h"

#include "core/evaluation/statistics/proportion.h"
#include "core/registration/judging/within_2mm.h"
#include "core/registration/registration.h"
#include "core/support/format_number.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>

namespace angiopose::benchmarks {
namespace {

using core::fixedText;
using Predicate = bool (*)(const TrustRun&);

constexpr double grossMm = 5.0;

bool isGood(const TrustRun& run)
{
    return run.isWithin();
}
bool isModerate(const TrustRun& run)
{
    return !run.isImpossible && !run.isWithin() && run.errorMm <= grossMm;
}
bool isGross(const TrustRun& run)
{
    return !run.isImpossible && run.errorMm > grossMm;
}
bool isImpossible(const TrustRun& run)
{
    return run.isImpossible;
}
bool isWrong(const TrustRun& run)
{
    return !run.isImpossible && !run.isWithin();
}
bool isFlagged(const TrustRun& run)
{
    return !run.result.trustworthy;
}

std::string flaggedOf(const std::vector<TrustRun>& runs, Predicate isMeant)
{
    const auto meant = std::ranges::count_if(runs, isMeant);
    const auto flagged = std::ranges::count_if(runs, [&](const TrustRun& r) { return isMeant(r) && isFlagged(r); });
    return meant == 0 ? "–" : std::to_string(flagged) + " of " + std::to_string(meant);
}

core::ResultTable::Row flagRow(const std::string& name, const std::vector<TrustRun>& runs)
{
    return {{name, flaggedOf(runs, isGood), flaggedOf(runs, isModerate), flaggedOf(runs, isGross),
             flaggedOf(runs, isImpossible)},
            false};
}

/// Formats a share with its 95 % interval: "44 of 47 (94 %, 82–98)".
std::string shareText(const std::vector<TrustRun>& runs, Predicate isMeant, Predicate holds)
{
    std::map<std::string, core::ClusterCount> byTree;
    int successes = 0;
    int count = 0;
    for (const TrustRun& run : runs) {
        if (isMeant(run)) {
            core::ClusterCount& tree = byTree[run.tree];
            tree.count += 1;
            tree.successes += holds(run) ? 1 : 0;
            successes += holds(run) ? 1 : 0;
            ++count;
        }
    }
    if (count == 0) {
        return "none";
    }
    std::vector<core::ClusterCount> counts;
    for (const auto& [name, tree] : byTree) {
        counts.push_back(tree);
    }
    const core::Interval interval = core::clusteredInterval(counts);
    return std::to_string(successes) + " of " + std::to_string(count) + " (" + fixedText(100.0 * successes / count, 1) +
           " %, 95 % interval " + fixedText(100.0 * interval.low, 1) + "–" + fixedText(100.0 * interval.high, 1) + ")";
}

double meanOf(const std::vector<TrustRun>& runs, double (*value)(const TrustRun&))
{
    double sum = 0.0;
    for (const TrustRun& run : runs) {
        sum += value(run);
    }
    return sum / static_cast<double>(runs.size());
}

double probabilityOf(const TrustRun& run)
{
    return run.result.probabilityWithin2Mm.value_or(0.5);
}

double squaredError(const TrustRun& run)
{
    const double off = probabilityOf(run) - (run.isWithin() ? 1.0 : 0.0);
    return off * off;
}

}   // namespace

TrustRun runOf(const RequestedCase& asked)
{
    TrustRun run{asked.tree, asked.kind, asked.isImpossible, 0.0, {}};
    const auto result = core::registerVessels(asked.input, {});
    if (!result) {
        std::fprintf(stderr, "%s, %s: %s\n", asked.tree.c_str(), asked.kind.c_str(),
                     result.error().message.text().c_str());
        run.errorMm = 1000.0;
        return run;
    }
    run.result = result.value();
    run.errorMm = overlayErrorMm(asked, run.result.cameraFromPatient);
    return run;
}

std::size_t treeCount(const std::vector<TrustRun>& runs)
{
    std::set<std::string> names;
    for (const TrustRun& run : runs) {
        names.insert(run.tree);
    }
    return names.size();
}

core::ResultTable flagTable(const std::vector<TrustRun>& runs)
{
    std::vector<std::string> order;
    std::map<std::string, std::vector<TrustRun>> byKind;
    for (const TrustRun& run : runs) {
        if (byKind[run.kind].empty()) {
            order.push_back(run.kind);
        }
        byKind[run.kind].push_back(run);
    }
    core::ResultTable table;
    table.columns = {"flagged", "of below 2 mm", "of 2 to 5 mm", "of above 5 mm", "of impossible"};
    for (const std::string& kind : order) {
        table.rows.push_back(flagRow(kind, byKind[kind]));
    }
    table.rows.push_back(flagRow("all", runs));
    return table;
}

core::ResultTable reliabilityTable(const std::vector<TrustRun>& runs)
{
    constexpr std::array<double, 9> edges{0.0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.9, 0.97, 1.0};
    core::ResultTable table;
    table.columns = {"probability stated", "runs", "mean stated", "within 2 mm"};
    for (std::size_t bin = 0; bin + 1 < edges.size(); ++bin) {
        std::vector<TrustRun> inside;
        std::ranges::copy_if(runs, std::back_inserter(inside), [&](const TrustRun& run) {
            const double p = probabilityOf(run);
            return p >= edges[bin] && (p < edges[bin + 1] || bin + 2 == edges.size());
        });
        if (!inside.empty()) {
            table.rows.push_back(
                {{fixedText(edges[bin], 2) + "–" + fixedText(edges[bin + 1], 2), std::to_string(inside.size()),
                  fixedText(meanOf(inside, probabilityOf), 3),
                  fixedText(meanOf(inside, [](const TrustRun& run) { return run.isWithin() ? 1.0 : 0.0; }), 3)},
                 false});
        }
    }
    return table;
}

std::string summaryOf(const std::vector<TrustRun>& runs)
{
    return "errors of 2 mm and more flagged, impossible cases left out: " + shareText(runs, isWrong, isFlagged) +
           "\nof them above 5 mm: " + shareText(runs, isGross, isFlagged) +
           "\nimpossible cases flagged: " + shareText(runs, isImpossible, isFlagged) +
           "\nfalse alarms: " + shareText(runs, isGood, isFlagged) +
           "\nBrier score of the probability: " + fixedText(meanOf(runs, squaredError), 4) + "\n";
}

std::string csvOf(const std::vector<TrustRun>& runs)
{
    std::ostringstream text;
    text << "tree,kind,impossible,errorMm,trustworthy";
    for (const std::string_view name : core::featureNames()) {
        text << ',' << name;
    }
    text << ",reasons\n";
    for (const TrustRun& run : runs) {
        text << run.tree << ",\"" << run.kind << "\"," << run.isImpossible << ',' << run.errorMm << ','
             << run.result.trustworthy;
        for (const double value : core::featureVector(run.result)) {
            text << ',' << value;
        }
        text << ",\"";
        for (const core::Message& warning : run.result.warnings) {
            text << warning.id() << ' ';
        }
        text << "\"\n";
    }
    return text.str();
}

}   // namespace angiopose::benchmarks
