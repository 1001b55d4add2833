#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::readText;
using test::runCli;

std::size_t countOf(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++count;
    }
    return count;
}

/// Text in the encoding of PDF document properties.
std::string utf16(const std::string& ascii)
{
    std::string bytes;
    for (const char letter : ascii) {
        bytes += '\0';
        bytes += letter;
    }
    return bytes;
}

/// Fixture: writes reports. runCli has no display; the language is that of the desktop.
class CliReport : public ::testing::Test {
protected:
    void SetUp() override
    {
        setenv("LC_ALL", "C.UTF-8", 1);
        setenv("XDG_CONFIG_HOME", folder_.file("config").c_str(), 1);
        const auto simulated = runCli({"simulate", "--seed", "3", "--branches", "8", "--output", in("demo")});
        ASSERT_EQ(simulated.exitCode, 0) << simulated.messages;
    }
    void TearDown() override
    {
        unsetenv("LC_ALL");
        unsetenv("XDG_CONFIG_HOME");
    }

    test::ProgramOutcome reported(const std::string& name, const std::vector<std::string>& more = {})
    {
        std::vector<std::string> words{"report", in("demo/case.angiopose"), "--output", in(name)};
        words.insert(words.end(), more.begin(), more.end());
        return runCli(words);
    }
    std::string in(const std::string& name) const { return folder_.file(name); }

    const test::TemporaryFolder folder_;
};

TEST_F(CliReport, IsAPageWithPicturesVerdictAndAuthor)
{
    const auto outcome = reported("report.html", {"--register", "--author", "Ada <MD>"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    EXPECT_EQ(outcome.messages, "");
    const std::string page = readText(in("report.html"));
    EXPECT_EQ(countOf(page, "data:image/png;base64,"), 2U) << "the overlay and the program's mark";
    EXPECT_GT(page.size(), 200000U) << "the overlay is large enough for print";
    for (const char* wanted : {">Reliable<", "Before: initial pose", "After: registered", "Colors: distance",
                               "Median distance", "Ada &lt;MD&gt;", "identity hidden", "Not for clinical use"}) {
        EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
    }
    EXPECT_EQ(page.find(">Not reliable<"), std::string::npos);
}

TEST_F(CliReport, TellsItsTimeWithTheZone)
{
    setenv("TZ", "Asia/Kolkata", 1);
    const auto outcome = reported("report.html");
    unsetenv("TZ");
    ASSERT_EQ(outcome.exitCode, 4) << outcome.messages;
    const std::regex iso("20[0-9]{2}-[01][0-9]-[0-3][0-9] [0-2][0-9]:[0-5][0-9] UTC\\+05:30");
    EXPECT_TRUE(std::regex_search(readText(in("report.html")), iso));
}

TEST_F(CliReport, IsAPdfWithTheTitleOfTheCase)
{
    const auto outcome = reported("report.PDF", {"--register"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    const std::string pdf = readText(in("report.PDF"));
    EXPECT_TRUE(pdf.starts_with("%PDF"));
    const auto title = nlohmann::json::parse(readText(in("demo/case.angiopose")))["title"].get<std::string>();
    EXPECT_NE(pdf.find(utf16(title)), std::string::npos) << title;
    EXPECT_GT(pdf.size(), 20000U) << "the pictures are in it";
}

/// Without --register the report uses the pose of the case, which comes from the gantry angles.
TEST_F(CliReport, OfAPoseThatIsNotToBeTrustedSaysSoAndEndsWith4)
{
    const auto start = reported("start.html");
    EXPECT_EQ(start.exitCode, 4) << start.messages;
    EXPECT_NE(start.messages.find("not reliable"), std::string::npos) << start.messages;
    const std::string page = readText(in("start.html"));
    EXPECT_NE(page.find(">Not reliable<"), std::string::npos);
    EXPECT_EQ(page.find("Before: initial pose"), std::string::npos) << "one picture: it is the start pose";

    ASSERT_EQ(runCli({"simulate", "--seed", "4", "--branches", "8", "--output", in("other")}).exitCode, 0);
    fs::copy_file(in("other/tree.vtp"), in("demo/tree.vtp"), fs::copy_options::overwrite_existing);
    const auto foreign = reported("foreign.html", {"--register"});
    EXPECT_EQ(foreign.exitCode, 4) << foreign.messages;
    EXPECT_NE(readText(in("foreign.html")).find(">Not reliable<"), std::string::npos);
}

TEST_F(CliReport, NamesThePatientAndFollowsATemplateWhereThatIsWanted)
{
    folder_.write("letter.html", "<html><body>Ward 7{{notice}}{{warnings}}{{patient}}{{views}}</body></html>");
    ASSERT_EQ(reported("named.html", {"--identity", "--template", in("letter.html")}).exitCode, 4);
    const std::string page = readText(in("named.html"));
    EXPECT_NE(page.find("Ward 7"), std::string::npos);
    EXPECT_EQ(page.find("identity hidden"), std::string::npos);

    folder_.write("letter.html", "<html><body>{{notice}}{{views}}</body></html>");
    const auto lacking = reported("lacking.html", {"--template", in("letter.html")});
    EXPECT_EQ(lacking.exitCode, 3);
    EXPECT_NE(lacking.messages.find("{{warnings}}"), std::string::npos) << lacking.messages;
    EXPECT_FALSE(fs::exists(in("lacking.html")));
}

TEST_F(CliReport, SpeaksTheLanguageThatIsAskedFor)
{
    ASSERT_EQ(reported("bericht.html", {"--language", "de"}).exitCode, 4);
    const std::string page = readText(in("bericht.html"));
    EXPECT_NE(page.find(">Nicht verlässlich<"), std::string::npos);
    EXPECT_EQ(page.find(">Not reliable<"), std::string::npos);
    const auto unknown = reported("rapport.html", {"--language", "fr"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.messages.find("zh_CN"), std::string::npos) << unknown.messages;
    EXPECT_FALSE(fs::exists(in("rapport.html")));
}

/// Two programs produce a report; each file opened or written must be logged once.
TEST_F(CliReport, IsOnceInTheAuditFile)
{
    setenv("ANGIOPOSE_AUDIT_FILE", in("audit.jsonl").c_str(), 1);
    const auto outcome = reported("report.html");
    unsetenv("ANGIOPOSE_AUDIT_FILE");
    ASSERT_EQ(outcome.exitCode, 4) << outcome.messages;
    const std::string lines = readText(in("audit.jsonl"));
    EXPECT_EQ(countOf(lines, "\n"), 2U) << lines;
    EXPECT_EQ(countOf(lines, in("demo/case.angiopose")), 1U) << lines;
    EXPECT_EQ(countOf(lines, in("report.html")), 1U) << lines;
}

TEST_F(CliReport, NamesWhatIsMissingAndWritesNothing)
{
    const auto missing = runCli({"report", in("nowhere.angiopose"), "--output", in("report.pdf")});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.messages.find("nowhere.angiopose"), std::string::npos) << missing.messages;
    const auto ending = reported("report.doc");
    EXPECT_EQ(ending.exitCode, 2);
    EXPECT_NE(ending.messages.find(".pdf or .html"), std::string::npos) << ending.messages;
    const auto nowhere = reported("no/such/folder/report.pdf");
    EXPECT_EQ(nowhere.exitCode, 3);
    EXPECT_NE(nowhere.messages.find("no/such/folder/report.pdf"), std::string::npos) << nowhere.messages;
    EXPECT_FALSE(fs::exists(in("report.pdf")) || fs::exists(in("report.doc")));
}

/// Only the command-line program is installed, as in a container without the window.
TEST_F(CliReport, SaysWhereTheProgramIsLookedForThatWritesReports)
{
    fs::create_directories(in("bin"));
    fs::copy_file(CLI_PROGRAM, in("bin/angiopose-cli"));
    const auto outcome =
        test::runProgram(in("bin/angiopose-cli"), {"report", in("demo/case.angiopose"), "--output", in("report.pdf")});
    EXPECT_EQ(outcome.exitCode, 3);
    EXPECT_NE(outcome.messages.find(in("bin/angiopose")), std::string::npos) << outcome.messages;
    EXPECT_NE(outcome.messages.find("Install"), std::string::npos) << outcome.messages;
}

/// Interrupts the report while vessels are traced in a scan, which takes seconds.
TEST_F(CliReport, IsStoppedByCtrlC)
{
    ASSERT_EQ(runCli({"simulate", "--seed", "3", "--scan", "--output", in("scanned")}).exitCode, 0);
    folder_.write("scanned/scan.angiopose",
                  R"({"format": "angiopose-case", "version": 1, "vessel": {"volume": {"path": "scan.nii.gz"}},
                      "angiogram": {"image": {"path": "angiogram.dcm"}}})");
    const auto outcome = runCli({"report", in("scanned/scan.angiopose"), "--output", in("report.pdf")},
                                /*interruptAfterSeconds=*/0.5);
    EXPECT_EQ(outcome.exitCode, 130) << outcome.messages;
    EXPECT_FALSE(fs::exists(in("report.pdf")));
}

}   // namespace
