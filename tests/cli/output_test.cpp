#include "io/support/case_lock.h"
#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <sys/wait.h>
#include <cstdlib>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

TEST(Output, ThatDoesNotArriveIsAFailureWithASentence)
{
    const test::TemporaryFolder folder;
    const std::string messages = folder.file("messages.txt");
    for (const std::string arguments : {"schema", "--version", "info --help", "info --json /nowhere"}) {
        const std::string command = std::string(CLI_PROGRAM) + " " + arguments + " > /dev/full 2> " + messages;
        const int status = std::system(command.c_str());
        ASSERT_TRUE(WIFEXITED(status)) << arguments;
        EXPECT_EQ(WEXITSTATUS(status), 3) << arguments;
        EXPECT_NE(test::readText(messages).find("was not written completely"), std::string::npos) << arguments;
    }
}

/// Titles with control sequences, one that would clear the screen and one that would rename the terminal.
TEST(Output, ShowsCommandsToTheTerminalAndDoesNotPassThemOn)
{
    const test::TemporaryFolder folder;
    const auto demo = test::runCli({"simulate", "--seed", "3", "--output", folder.file("demo")});
    ASSERT_EQ(demo.exitCode, 0) << demo.messages;
    const std::string path = folder.file("demo/case.angiopose");
    auto json = nlohmann::ordered_json::parse(test::readText(path));
    json["title"] = "A\x1b[2JB\u009b2JC\x7f Ä";
    folder.write("demo/case.angiopose", json.dump());
    const auto info = test::runCli({"info", path});
    EXPECT_EQ(info.exitCode, 0) << info.messages;
    EXPECT_NE(info.output.find("A?[2JB?2JC? Ä"), std::string::npos) << info.output;
    const auto missing = test::runCli({"info", folder.file("no\x1b]0;x\x07.swc")});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.messages.find("no?]0;x?.swc"), std::string::npos) << missing.messages;
    const auto report = test::runCli({"report", folder.file("no\x1b[2J.angiopose"), "--output", folder.file("a.pdf")});
    EXPECT_EQ(report.exitCode, 3);
    EXPECT_NE(report.messages.find("no?[2J.angiopose"), std::string::npos) << report.messages;
}

TEST(Simulate, LeavesACaseAloneThatIsOpenElsewhere)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.write("demo/case.angiopose", "of somebody");
    {
        const io::CaseLock lock(path);
        const auto run = test::runCli({"simulate", "--seed", "3", "--output", folder.file("demo")});
        EXPECT_EQ(run.exitCode, 3);
        EXPECT_NE(run.messages.find("open elsewhere"), std::string::npos) << run.messages;
        EXPECT_EQ(test::readText(path), "of somebody");
        EXPECT_FALSE(std::filesystem::exists(folder.file("demo/tree.vtp")));
    }
    EXPECT_EQ(test::runCli({"simulate", "--seed", "3", "--output", folder.file("demo")}).exitCode, 0);
}

}   // namespace
