// Tests registration outside the project's own simulator, with independent trees, projection, sampling and noise. Real
// cerebral arteries are the test set; the development set serves only to choose thresholds.

#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/foreign/answer.h"

#include <algorithm>
#include <cstdio>

using namespace angiopose;

namespace {

using namespace benchmarks;
using core::fixedText;

constexpr double goodMm = 2.0;
constexpr double grossMm = 5.0;

const char* const usage =
    "foreign_targets_table\n"
    "  --family <name>   real: cerebral arteries of patients; development: trees made up (real)\n"
    "  --scenes <list>   whole,one,two,vessel,leaves,points,pixels,rows,wide,\n"
    "                    other,other-one,other-curves,other-points (all)\n"
    "  --trials <n>      for each tree and scene (4)\n"
    "  --first <n>       number of the first trial (0)\n"
    "  --each            one line for each registration, too\n";

std::vector<double> all(const std::vector<ForeignAnswer>& answers, double (*value)(const ForeignAnswer&))
{
    std::vector<double> values;
    for (const ForeignAnswer& answer : answers) {
        values.push_back(value(answer));
    }
    return values;
}

template <class Predicate>
int countOf(const std::vector<ForeignAnswer>& answers, const Predicate& holds)
{
    return static_cast<int>(std::count_if(answers.begin(), answers.end(), holds));
}

std::string ofText(int count, int whole)
{
    return std::to_string(count) + " of " + std::to_string(whole);
}

core::ResultTable::Row rowOf(const NamedScene& scene, const std::vector<ForeignAnswer>& answers)
{
    const bool isImpossible = scene.key.starts_with("other");
    const auto isGood = [&](const ForeignAnswer& a) { return !isImpossible && a.error.inPlaneMm < goodMm; };
    const int good = countOf(answers, isGood);
    const int count = static_cast<int>(answers.size());
    const int gross = countOf(answers, [](const ForeignAnswer& a) { return a.error.inPlaneMm > grossMm; });
    const int flagged = countOf(answers, [&](const ForeignAnswer& a) { return !isGood(a) && !a.isTrusted; });
    const int alarms = countOf(answers, [&](const ForeignAnswer& a) { return isGood(a) && !a.isTrusted; });
    const std::vector<double> inPlane = all(answers, [](const ForeignAnswer& a) { return a.error.inPlaneMm; });
    const std::vector<double> space = all(answers, [](const ForeignAnswer& a) { return a.error.spaceMm; });
    const std::vector<double> turns = all(answers, [](const ForeignAnswer& a) { return a.error.turnDeg; });
    const std::vector<double> times = all(answers, [](const ForeignAnswer& a) { return a.timeMs; });
    const auto unless = [&](std::string text) { return isImpossible ? std::string("–") : text; };
    return {{std::string(scene.words), unless(ofText(good, count)), unless(std::to_string(gross)),
             ofText(flagged, count - good), unless(ofText(alarms, good)),
             unless(fixedText(core::quantile(inPlane, 0.5), 3)), unless(fixedText(core::quantile(space, 0.5), 2)),
             unless(fixedText(core::quantile(turns, 0.5), 2)), fixedText(core::quantile(times, 0.5), 0),
             fixedText(core::quantile(times, 1.0), 0)},
            false};
}

void printAnswer(const NamedScene& scene, const RootedTree& tree, std::uint64_t trial, const ForeignAnswer& answer)
{
    std::printf("%-10s %-10s %3d  %8.3f mm  %8.2f mm  %6.2f°  %-9s %6.0f ms\n", std::string(scene.key).c_str(),
                tree.name.c_str(), static_cast<int>(trial), answer.error.inPlaneMm, answer.error.spaceMm,
                answer.error.turnDeg, answer.isTrusted ? "trusted" : "flagged", answer.timeMs);
    std::fflush(stdout);
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    const std::string family = arguments.text("family", "real");
    const std::vector<RootedTree> trees = treesOfFamily(family);
    if (trees.empty()) {
        return 1;
    }
    const std::vector<std::string> wanted = arguments.list(
        "scenes", "whole,one,two,vessel,leaves,points,pixels,rows,wide,other,other-one,other-curves,other-points");
    const auto first = static_cast<std::uint64_t>(arguments.number("first", 0));
    const auto trials = static_cast<std::uint64_t>(arguments.number("trials", 4));
    core::ResultTable table;
    table.columns = {"image shows", "below 2 mm", "above 5 mm", "flagged of the rest", "false alarms",
                     "in plane mm", "3-D mm",     "turn °",     "median ms",           "longest ms"};
    for (const NamedScene& scene : foreignScenes) {
        if (std::find(wanted.begin(), wanted.end(), scene.key) == wanted.end()) {
            continue;
        }
        std::vector<ForeignAnswer> answers;
        for (std::size_t tree = 0; tree < trees.size(); ++tree) {
            for (std::uint64_t trial = first; trial < first + trials; ++trial) {
                answers.push_back(ask(makeForeignCase(trees, tree, scene.scene, trial)));
                if (arguments.isSet("each")) {
                    printAnswer(scene, trees[tree], trial, answers.back());
                }
            }
        }
        table.rows.push_back(rowOf(scene, answers));
    }
    std::printf("%s trees, starts up to 15°, 30 mm across and 50 mm along the ray off; medians of errors\n\n%s\n",
                family == "real" ? "Real cerebral" : "Made-up", io::toPlainText(table).c_str());
    return 0;
}
