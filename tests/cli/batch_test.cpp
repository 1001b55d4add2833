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
using test::writeText;

std::ptrdiff_t linesOf(const std::string& path)
{
    const std::string text = readText(path);
    return std::count(text.begin(), text.end(), '\n');
}

TEST(CliBatch, WrongUsageAndBrokenManifestsAreTold)
{
    const test::TemporaryFolder folder;
    const std::string manifest = folder.file("cases.csv");
    EXPECT_EQ(runCli({"batch"}).exitCode, 2);
    EXPECT_EQ(runCli({"batch", manifest}).exitCode, 2);
    EXPECT_EQ(runCli({"batch", manifest, "--output", folder.file("out")}).exitCode, 3);
    for (const std::string text :
         {"", "path\na.angiopose\n", "case\n", "case,frame\na.angiopose,second\n", "case,name\na.angiopose,x/y\n",
          "case,name\na.angiopose,x\nb.angiopose,x\n", "case,name\n,x\n"}) {
        writeText(manifest, text);
        const auto outcome = runCli({"batch", manifest, "--output", folder.file("out")});
        EXPECT_EQ(outcome.exitCode, 3) << text;
        EXPECT_NE(outcome.messages.find("cases.csv"), std::string::npos) << outcome.messages;
    }
    writeText(manifest, "case\na.angiopose\n");
    EXPECT_EQ(runCli({"batch", manifest, "--shard", "2", "--output", folder.file("out")}).exitCode, 2);
    EXPECT_FALSE(fs::exists(folder.file("out/summary.csv")));
}

TEST(CliBatch, AFailingCaseDoesNotStopTheOthers)
{
    const test::TemporaryFolder folder;
    ASSERT_EQ(runCli({"simulate", "--seed", "3", "--output", folder.file("demo")}).exitCode, 0);
    writeText(folder.file("broken.angiopose"), "{");
    writeText(folder.file("cases.csv"),
              "case,name,method,frame\n"
              "broken.angiopose,,,\n"
              "missing.angiopose,,,\n"
              "demo/case.angiopose,good,,\n"
              "demo/case.angiopose,magic,magic,\n"
              "demo/case.angiopose,far,,99\n");
    const auto outcome = runCli({"batch", folder.file("cases.csv"), "--output", folder.file("out")});
    EXPECT_EQ(outcome.exitCode, 3) << outcome.messages;
    EXPECT_TRUE(fs::exists(folder.file("out/good/result.json")));
    EXPECT_TRUE(fs::exists(folder.file("out/good/overlay.png")));
    const std::string summary = readText(folder.file("out/summary.csv"));
    EXPECT_EQ(std::count(summary.begin(), summary.end(), '\n'), 6);
    EXPECT_NE(summary.find("1,\"0001-broken\","), std::string::npos) << summary;
    EXPECT_NE(summary.find("3,\"good\","), std::string::npos) << summary;
    EXPECT_NE(summary.find(",done,angiopose,"), std::string::npos) << summary;
    EXPECT_NE(summary.find("frame 99 does not exist"), std::string::npos) << summary;

    // Two parts into one folder, rows 2 and 4 here: neither writes over the other's table.
    EXPECT_EQ(runCli({"batch", folder.file("cases.csv"), "--shard", "1/2", "--output", folder.file("part")}).exitCode,
              3);
    EXPECT_EQ(linesOf(folder.file("part/summary-1-of-2.csv")), 4);
    const auto part = runCli({"batch", folder.file("cases.csv"), "--shard", "2/2", "--output", folder.file("part")});
    EXPECT_EQ(part.exitCode, 3);
    const std::string rows = readText(folder.file("part/summary-2-of-2.csv"));
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 3) << rows;
    EXPECT_NE(rows.find("\n2,"), std::string::npos);
    EXPECT_NE(rows.find("\n4,"), std::string::npos);
    EXPECT_EQ(linesOf(folder.file("part/summary-1-of-2.csv")), 4);
}

}   // namespace
