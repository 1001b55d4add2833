#include "tests/cli/run_program.h"
#include "tests/io/deidentify/planted_run.h"
#include "tests/support/patience.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

/// Fixture: a run with planted words, and separate user folders.
class CliSecrets : public ::testing::Test {
protected:
    CliSecrets()
    {
        ::setenv("XDG_STATE_HOME", folder.file("state").c_str(), 1);
        const std::vector<std::int16_t> pixels(
            static_cast<std::size_t>(2 * test::PlantedRun::columns * test::PlantedRun::rows), 100);
        runPath = folder.file("PLANTED.dcm");
        test::writeText(runPath, test::PlantedRun().content(pixels));
    }
    ~CliSecrets() override { ::unsetenv("XDG_STATE_HOME"); }

    static std::vector<nlohmann::json> linesOf(const std::string& path)
    {
        std::vector<nlohmann::json> lines;
        std::istringstream text(test::readText(path));
        for (std::string line; std::getline(text, line);) {
            lines.push_back(nlohmann::json::parse(line));
        }
        return lines;
    }

    test::TemporaryFolder folder;
    std::string runPath;
};

TEST_F(CliSecrets, AuditFileHoldsInputAndOutputWithTheirHashes)
{
    const std::string audit = folder.file("audit.jsonl");
    const std::string out = folder.file("out.dcm");
    ASSERT_EQ(test::runCli({"--audit", audit, "convert", runPath, out, "--deidentify"}).exitCode, 0);
    ::setenv("ANGIOPOSE_AUDIT_FILE", audit.c_str(), 1);
    EXPECT_EQ(test::runCli({"info", out}).exitCode, 0);
    EXPECT_EQ(test::runCli({"info", folder.file("gone.dcm")}).exitCode, 3);
    ::unsetenv("ANGIOPOSE_AUDIT_FILE");
    EXPECT_EQ(test::runCli({"info", out}).exitCode, 0);
    const auto lines = linesOf(audit);
    ASSERT_EQ(lines.size(), 3U) << test::readText(audit);
    EXPECT_EQ(lines[0]["event"], "opened");
    EXPECT_EQ(lines[0]["files"][0]["path"], runPath);
    EXPECT_EQ(lines[1]["event"], "deidentified");
    EXPECT_EQ(lines[1]["files"][0]["path"], out);
    EXPECT_EQ(lines[1]["files"][0]["sha256"], lines[2]["files"][0]["sha256"]);
    EXPECT_EQ(lines[2]["event"], "opened");
}

TEST_F(CliSecrets, AnAuditFileThatCannotBeWrittenIsReported)
{
    const auto outcome = test::runCli({"--audit", folder.file("gone/audit.jsonl"), "info", runPath});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.messages.find("audit log cannot be written"), std::string::npos) << outcome.messages;
}

TEST_F(CliSecrets, NothingPlantedIsLeftInExportsPacksAndBundles)
{
    ASSERT_EQ(test::runCli({"simulate", "--seed", "3", "--output", folder.file("PLANTEDcase")}).exitCode, 0);
    const std::string session = folder.file("PLANTEDcase/case.angiopose");
    std::string text = test::readText(session);
    const std::size_t brace = text.find('{');
    text.insert(brace + 1, "\"title\": \"PLANTED title\", \"plantedKey\": \"PLANTED key\", ");
    auto json = nlohmann::json::parse(text, nullptr, false);
    ASSERT_FALSE(json.is_discarded());
    test::writeText(session, json.dump());
    const std::string out = folder.file("out");
    fs::create_directories(out);
    ASSERT_EQ(test::runCli({"convert", runPath, out + "/run.dcm", "--deidentify"}).exitCode, 0);
    ASSERT_EQ(test::runCli({"pack", session, out + "/pack.zip", "--deidentify"}).exitCode, 0);
    ASSERT_EQ(test::runCli({"support-bundle", out + "/support.zip", "--case", session}).exitCode, 0);
    const auto shown = test::runCli({"support-bundle", "--show", "--case", session});
    EXPECT_EQ(shown.output.find("PLANTED"), std::string::npos) << shown.output;
    EXPECT_NE(shown.output.find("ITK: "), std::string::npos) << shown.output;
    for (const char* archive : {"pack", "support"}) {
        ASSERT_EQ(std::system(("cd '" + out + "' && mkdir " + archive + " && cd " + archive +
                               " && cmake -E tar xf ../" + archive + ".zip")
                                  .c_str()),
                  0);
    }
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
        EXPECT_EQ(entry.path().filename().string().find("PLANTED"), std::string::npos) << entry;
        if (entry.is_regular_file()) {
            ++files;
            EXPECT_EQ(test::readText(entry.path()).find("PLANTED"), std::string::npos) << entry;
        }
    }
    EXPECT_GT(files, 6);
}

/// 8 × 8 pixels with a description, little endian.
std::string plantedTiff()
{
    std::string file("II*\0\x08\0\0\0\x09\0", 10);
    const auto number = [&file](unsigned value, int bytes) {
        for (int i = 0; i < bytes; ++i) {
            file += static_cast<char>(value >> (8 * i) & 0xffU);
        }
    };
    const auto entry = [&number](unsigned tag, unsigned type, unsigned count, unsigned value) {
        number(tag, 2);
        number(type, 2);
        number(count, 4);
        number(value, 4);
    };
    constexpr unsigned wordsAt = 10 + 9 * 12 + 4, pixelsAt = wordsAt + 8;
    entry(256, 3, 1, 8);
    entry(257, 3, 1, 8);
    entry(258, 3, 1, 8);
    entry(259, 3, 1, 1);
    entry(262, 3, 1, 1);
    entry(270, 2, 8, wordsAt);
    entry(273, 4, 1, pixelsAt);
    entry(278, 3, 1, 8);
    entry(279, 4, 1, 64);
    number(0, 4);
    file += std::string("PLANTED\0", 8);
    for (int i = 0; i < 64; ++i) {
        file += static_cast<char>('0' + i);
    }
    return file;
}

TEST_F(CliSecrets, TiffIsConvertedWithoutIdentity)
{
    test::writeText(folder.file("in.tif"), plantedTiff());
    const auto outcome = test::runCli({"convert", folder.file("in.tif"), folder.file("out.tif"), "--deidentify"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    const std::string written = test::readText(folder.file("out.tif"));
    EXPECT_EQ(written.find("PLANTED"), std::string::npos);
    EXPECT_NE(written.find(plantedTiff().substr(plantedTiff().size() - 64)), std::string::npos) << "its pixels";
}

TEST_F(CliSecrets, AFaultLeavesADumpAndTheSameSignal)
{
    if (test::isSanitized) {
        GTEST_SKIP() << "the sanitizer takes the signals";
    }
    const std::string script = folder.file("crash.sh");
    test::writeText(script, std::string("'") + CLI_PROGRAM + "' evaluate robustness --trials 1000 --output '" +
                                folder.file("long") + "' >/dev/null 2>&1 &\np=$!\nsleep 2\nkill -SEGV $p\nwait $p\n");
    const int status = std::system(("bash '" + script + "' 2>/dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 128 + 11) << "it is to end as it would without the dump";
    std::string dump;
    for (const auto& entry : fs::directory_iterator(folder.file("state/angiopose/crashes"))) {
        dump = test::readText(entry.path());
    }
    EXPECT_NE(dump.find("program: angiopose-cli"), std::string::npos) << dump;
    EXPECT_NE(dump.find("SIGSEGV (11), code 0, sent by a process"), std::string::npos) << dump;
    EXPECT_EQ(dump.find(folder.file("")), std::string::npos) << dump;
}

}   // namespace
