#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using test::runCli;

TEST(Cli, HelpAndVersionSucceed)
{
    EXPECT_EQ(runCli({"--version"}).exitCode, 0);
    const auto help = runCli({"register", "--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_NE(help.output.find("Example"), std::string::npos);
    EXPECT_NE(help.output.find("dynaweight"), std::string::npos);
}

TEST(Cli, WrongUsageGivesTwo)
{
    EXPECT_EQ(runCli({}).exitCode, 2);
    EXPECT_EQ(runCli({"dance"}).exitCode, 2);
    EXPECT_EQ(runCli({"register"}).exitCode, 2);
    EXPECT_EQ(runCli({"simulate", "--seed", "many", "--output", "x"}).exitCode, 2);
}

TEST(Cli, TellsWhatWasPerhapsMeant)
{
    EXPECT_NE(runCli({"regsiter", "a"}).messages.find("Unknown command 'regsiter'. Did you mean register?"),
              std::string::npos);
    const auto option = runCli({"register", "a", "--outptu=b"});
    EXPECT_EQ(option.exitCode, 2);
    EXPECT_NE(option.messages.find("Unknown option --outptu. Did you mean --output?"), std::string::npos);
    EXPECT_NE(option.messages.find("angiopose-cli register --help"), std::string::npos);
    EXPECT_EQ(runCli({"dance"}).messages.find("Did you mean"), std::string::npos);
}

TEST(Cli, HelpMayBeAskedForInWords)
{
    const auto asked = runCli({"help", "trace-vessel"});
    EXPECT_EQ(asked.exitCode, 0);
    EXPECT_EQ(asked.output, runCli({"trace-vessel", "--help"}).output);
    EXPECT_EQ(runCli({"help"}).output, runCli({"--help"}).output);
}

TEST(Cli, AMissingInputIsNamed)
{
    for (const std::string command : {"register", "info", "validate"}) {
        const auto outcome = runCli({command, "/nowhere/case.angiopose"});
        EXPECT_EQ(outcome.exitCode, 3) << command;
        EXPECT_NE(outcome.messages.find("/nowhere/case.angiopose"), std::string::npos) << command;
        EXPECT_TRUE(outcome.output.empty()) << command;
    }
}

TEST(Cli, BrokenCasesAreRefusedWithTheReason)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("case.angiopose");
    for (const std::string text :
         {"", "{", "[]", "{\"format\": \"something\"}", "{\"format\": \"angiopose-case\", \"version\": 99}",
          "{\"format\": \"angiopose-case\", \"version\": 1, \"vessel\": 3}"}) {
        test::writeText(path, text);
        EXPECT_EQ(runCli({"validate", path}).exitCode, 3) << text;
        const auto outcome = runCli({"register", path, "--output", folder.file("result")});
        EXPECT_EQ(outcome.exitCode, 3) << text;
        EXPECT_NE(outcome.messages.find(path), std::string::npos) << text;
    }
}

}   // namespace
