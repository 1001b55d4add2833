// Tests whether a result knows its possible error: compares its statements about the overlay with the truth. The
// artificial cases are for training (--dump, then fit_within_2mm.py); trees of patients and independent generators are
// the test set.

#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/judging_cases.h"
#include "tests/benchmark/mixed_cases.h"
#include "tests/benchmark/trust_runs.h"

#include <cstdio>
#include <fstream>

using namespace angiopose;

namespace {

using namespace benchmarks;

const char* const usage =
    "trust_table\n"
    "  --world <name>    judging: trees of patients; made-up: what the probability was learned from (judging)\n"
    "  --cases <n>       of the made-up world (400)\n"
    "  --first <n>       number of its first case (0)\n"
    "  --trials <n>      of the judging world, for each tree and kind (1)\n"
    "  --dump <file>     CSV of the signs of every fit and its error\n";

std::vector<TrustRun> runsOfMadeUp(const Arguments& arguments)
{
    const auto first = static_cast<std::uint64_t>(arguments.number("first", 0));
    const auto cases = static_cast<std::uint64_t>(arguments.number("cases", 400));
    std::vector<TrustRun> runs;
    for (std::uint64_t number = first; number < first + cases; ++number) {
        runs.push_back(runOf(mixedCase(number)));
    }
    return runs;
}

std::vector<TrustRun> runsOfJudging(const Arguments& arguments)
{
    const std::vector<RootedTree> trees = judgingTrees(TEST_DATA_DIR);
    const auto trials = static_cast<std::uint64_t>(arguments.number("trials", 1));
    std::vector<TrustRun> runs;
    for (std::size_t kind = 0; kind < judgingKindCount(); ++kind) {
        for (std::size_t tree = 0; tree < trees.size(); ++tree) {
            for (std::uint64_t trial = 0; trial < trials; ++trial) {
                runs.push_back(runOf(judgingCase(trees, tree, kind, trial)));
            }
        }
    }
    if (trees.empty()) {
        std::fprintf(stderr, "The trees of patients are not there.\n");
    }
    return runs;
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    const bool isMadeUp = arguments.text("world", "judging") == "made-up";
    const std::vector<TrustRun> runs = isMadeUp ? runsOfMadeUp(arguments) : runsOfJudging(arguments);
    if (runs.empty()) {
        return 1;
    }
    if (const std::string path = arguments.text("dump", ""); !path.empty()) {
        std::ofstream(path) << csvOf(runs);
    }
    std::printf("%s world, %zu registrations of %zu trees\n\n%s\n%s\n%s\n", isMadeUp ? "Made-up" : "Judging",
                runs.size(), treeCount(runs), io::toPlainText(flagTable(runs)).c_str(),
                io::toPlainText(reliabilityTable(runs)).c_str(), summaryOf(runs).c_str());
    return 0;
}
