#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::readText;
using test::runCli;

TEST(CliEvaluate, WrongUsageGivesTwoAndWritesNothing)
{
    const test::TemporaryFolder folder;
    const std::string output = folder.file("out");
    const std::vector<std::vector<std::string>> wrong{
        {"evaluate", "--output", output},
        {"evaluate", "magic", "--output", output},
        {"evaluate", "toy"},
        {"evaluate", "toy", "--method", "magic", "--output", output},
        {"evaluate", "toy", "--method", "dynaweight:magic", "--output", output},
        {"evaluate", "toy", "--condition", "magic", "--output", output},
        {"evaluate", "toy", "--trials", "0", "--output", output},
        {"evaluate", "toy", "--shard", "3/2", "--output", output},
        {"evaluate", "toy", "--shard", "0/2", "--output", output},
        {"evaluate", "toy", "--shard", "1/2x", "--output", output},
        {"evaluate", "toy", "--threads", "0", "--output", output},
        {"evaluate", "toy", "--shard", "1/2", "--merge", output, "--output", output},
    };
    for (const auto& arguments : wrong) {
        const auto outcome = runCli(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << outcome.messages;
        EXPECT_FALSE(outcome.messages.empty());
    }
    EXPECT_FALSE(fs::exists(output));
}

TEST(CliEvaluate, HelpListsExperimentsConditionsAndMethods)
{
    const auto help = runCli({"evaluate", "--help"});
    EXPECT_EQ(help.exitCode, 0);
    for (const std::string word : {"capture-range", "cam-2-5*", "dynaweight", "--merge a b"}) {
        EXPECT_NE(help.output.find(word), std::string::npos) << word;
    }
}

std::vector<std::string> toy(const std::string& output, const std::vector<std::string>& more)
{
    std::vector<std::string> arguments{
        "evaluate", "toy", "--condition", "b1-8,b1-44", "--method", "iterative-pnp,dynaweight:seed_noprior",
        "--trials", "3",   "--output",    output};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(CliEvaluate, MergedShardsGiveTheBytesOfOneRun)
{
    const test::TemporaryFolder folder;
    ASSERT_EQ(runCli(toy(folder.file("whole"), {"--threads", "2"})).exitCode, 0);
    ASSERT_EQ(runCli(toy(folder.file("a"), {"--shard", "1/2"})).exitCode, 0);
    ASSERT_EQ(runCli(toy(folder.file("b"), {"--shard", "2/2"})).exitCode, 0);
    const auto merged =
        runCli({"evaluate", "toy", "--merge", folder.file("b"), folder.file("a"), "--output", folder.file("merged")});
    ASSERT_EQ(merged.exitCode, 0) << merged.messages;
    const std::string whole = readText(folder.file("whole/runs.csv"));
    EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 1 + 2 * 2 * 3);
    EXPECT_EQ(readText(folder.file("merged/runs.csv")), whole);
    EXPECT_EQ(readText(folder.file("merged/histories.csv")), readText(folder.file("whole/histories.csv")));
    EXPECT_EQ(readText(folder.file("merged/toy-b1.tex")), readText(folder.file("whole/toy-b1.tex")));
    EXPECT_NE(readText(folder.file("whole/tables.md")).find("iterative-pnp, published"), std::string::npos);
}

TEST(CliEvaluate, MergingWhatIsNotThereOrNotThisFails)
{
    const test::TemporaryFolder folder;
    const auto missing =
        runCli({"evaluate", "toy", "--merge", folder.file("nowhere"), "--output", folder.file("merged")});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.messages.find("nowhere"), std::string::npos);
    ASSERT_EQ(runCli(toy(folder.file("a"), {})).exitCode, 0);
    EXPECT_EQ(runCli({"evaluate", "simulation", "--merge", folder.file("a"), "--output", folder.file("m")}).exitCode,
              3);
}

TEST(CliEvaluate, CtrlCKeepsWhatIsDone)
{
    const test::TemporaryFolder folder;
    const auto stopped = runCli({"evaluate", "toy", "--method", "iterative-pnp", "--condition", "b1-164", "--trials",
                                 "1000000", "--output", folder.file("out")},
                                1.0);
    EXPECT_EQ(stopped.exitCode, 130) << stopped.messages;
    EXPECT_LT(stopped.seconds, 10.0);
    const std::string runs = readText(folder.file("out/runs.csv"));
    EXPECT_GT(std::count(runs.begin(), runs.end(), '\n'), 1);
    EXPECT_TRUE(fs::exists(folder.file("out/tables.md")));
}

}   // namespace
