#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::readText;
using test::runCli;
using test::writeText;
using Json = nlohmann::json;

std::string smallStudy()
{
    return R"({"format": "angiopose-study", "version": 1, "name": "Small", "seed": 5, "casesPerSetting": 2,
               "trees": [{"grown": 1, "branches": 5, "extentMm": 100}, {"file": "own.swc", "rootRadiusMm": 2}],
               "settings": [{"name": "plain", "frames": 1, "width": 128, "height": 128},
                            {"name": "wrong", "frames": 1, "width": 128, "height": 128,
                             "header": {"distancePercent": 3, "angleDeg": 4}},
                            {"name": "bent", "frames": 1, "width": 128, "height": 128, "deformationMm": 1.5}]})";
}

std::set<std::string> linesOf(const std::string& text)
{
    std::istringstream stream(text);
    std::set<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.insert(line);
    }
    return lines;
}

class CliSimulateStudy : public ::testing::Test {
protected:
    void SetUp() override
    {
        writeText(folder.file("study.json"), smallStudy());
        // A trunk with one side branch, in SWC format.
        std::string swc;
        for (int k = 0; k < 40; ++k) {
            swc += std::to_string(k + 1) + " 3 0 0 " + std::to_string(2 * k - 40) + " 2 " +
                   std::to_string(k == 0 ? -1 : k) + "\n";
        }
        for (int k = 0; k < 20; ++k) {
            swc += std::to_string(41 + k) + " 3 " + std::to_string(2 * k + 2) + " " + std::to_string(k) + " 0 1 " +
                   std::to_string(k == 0 ? 21 : 40 + k) + "\n";
        }
        writeText(folder.file("own.swc"), swc);
    }

    test::ProgramOutcome simulate(const std::string& name, std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments{"simulate", "--study", folder.file("study.json"), "--output",
                                           folder.file(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments);
    }

    test::TemporaryFolder folder;
};

TEST_F(CliSimulateStudy, ThreadsAndShardsMakeTheSameBytes)
{
    const auto whole = simulate("whole", {"--threads", "2"});
    ASSERT_EQ(whole.exitCode, 0) << whole.messages;
    ASSERT_EQ(simulate("parts", {"--shard", "1/2"}).exitCode, 0);
    ASSERT_EQ(simulate("parts", {"--shard", "2/2"}).exitCode, 0);
    const auto sums = linesOf(readText(folder.file("whole/SHA256SUMS")));
    EXPECT_EQ(sums.size(), 6u * 5u + 2u);   // including the truth of two deformed trees
    EXPECT_EQ(
        linesOf(readText(folder.file("parts/SHA256SUMS-1-of-2")) + readText(folder.file("parts/SHA256SUMS-2-of-2"))),
        sums);
    EXPECT_EQ(readText(folder.file("parts/cases.csv")), readText(folder.file("whole/cases.csv")));
}

TEST_F(CliSimulateStudy, ItsListIsWhatBatchAndEvaluateOwnTake)
{
    ASSERT_EQ(simulate("study").exitCode, 0);
    const std::string list = folder.file("study/cases.csv");
    const auto judged =
        runCli({"evaluate", "own", list, "--method", "iterative-pnp", "--output", folder.file("judged")});
    ASSERT_EQ(judged.exitCode, 0) << judged.messages;
    EXPECT_TRUE(fs::exists(folder.file("judged/own-plain.tex")));
    EXPECT_TRUE(fs::exists(folder.file("judged/own-wrong.tex")));
    const auto batch = runCli({"batch", list, "--output", folder.file("batch")});
    EXPECT_TRUE(batch.exitCode == 0 || batch.exitCode == 4) << batch.messages;
    const std::string summary = readText(folder.file("batch/summary.csv"));
    EXPECT_EQ(std::count(summary.begin(), summary.end(), '\n'), 7);
}

TEST_F(CliSimulateStudy, AWrongHeaderChangesTheHeaderAlone)
{
    ASSERT_EQ(simulate("study").exitCode, 0);
    const auto poseOf = [&](const std::string& setting) {
        return Json::parse(readText(folder.file("study/" + setting + "/0001/true-pose.json"))).at("cameraFromPatient");
    };
    const auto distanceOf = [&](const std::string& setting) {
        const Json session = Json::parse(readText(folder.file("study/" + setting + "/0001/case.angiopose")));
        return session.at("geometry").at("sourceToDetectorMm").at("value").get<double>();
    };
    EXPECT_EQ(poseOf("plain"), poseOf("wrong"));
    EXPECT_NE(distanceOf("plain"), distanceOf("wrong"));
    EXPECT_NEAR(distanceOf("plain"), distanceOf("wrong"), 150.0);
    EXPECT_EQ(readText(folder.file("study/plain/0002/tree.vtp")), readText(folder.file("study/wrong/0002/tree.vtp")));
}

TEST_F(CliSimulateStudy, ThePublishedSetHasItsPublishedBytes)
{
    const fs::path studies = fs::path(__FILE__).parent_path() / "../../resources/studies";
    const auto outcome =
        runCli({"simulate", "--study", (studies / "reference.json").string(), "--output", folder.file("reference")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    EXPECT_EQ(readText(folder.file("reference/SHA256SUMS")), readText(studies / "reference.sha256"));
}

TEST_F(CliSimulateStudy, WrongStudiesAreRefusedNamingThePlace)
{
    const std::vector<std::array<std::string, 3>> changes{
        {"\"width\": 128", "\"widht\": 128", "widht"},
        {"\"frames\": 1", "\"frames\": 0", "settings[0]"},
        {"\"name\": \"plain\"", "\"name\": \"wrong\"", "wrong"},
        {"\"name\": \"plain\"", "\"name\": \"a/b\"", "a/b"},
        {"own.swc", "nowhere.swc", "nowhere.swc"},
        {"angiopose-study", "angiopose-case", "not a study file"},
        {"\"seed\": 5", "\"seed\": -5", "seed"},
        {"\"header\": {", "\"contrast\": {\"riseS\": 0}, \"header\": {", "contrast of settings[1]"},
        {"\"header\": {", "\"contrast\": {\"fast\": 1}, \"header\": {", "fast"},
        {"\"angleDeg\": 4", "\"angleDeg\": \"4\"", "header of settings[1]"}};
    for (const auto& [from, to, word] : changes) {
        std::string text = smallStudy();
        text.replace(text.find(from), from.size(), to);
        writeText(folder.file("study.json"), text);
        const auto outcome = simulate("out");
        EXPECT_EQ(outcome.exitCode, 3) << to;
        EXPECT_NE(outcome.messages.find(word), std::string::npos) << outcome.messages;
    }
    EXPECT_FALSE(fs::exists(folder.file("out")));
    EXPECT_EQ(runCli({"simulate", "--output", folder.file("out")}).exitCode, 2);
    EXPECT_EQ(runCli({"simulate", "--seed", "1", "--study", "x", "--output", folder.file("out")}).exitCode, 2);
}

}   // namespace
