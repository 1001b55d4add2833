#include "tests/cli/batch_files.h"
#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::readText;
using test::runCli;

/// Fixture: registers a simulated case, then keeps only its result and its inputs, in other places.
class CliResult : public testing::Test {
protected:
    void registerAndScatter(std::vector<std::string> more = {})
    {
        ASSERT_EQ(runCli({"simulate", "--seed", "3", "--branches", "8", "--output", in("demo")}).exitCode, 0);
        std::vector<std::string> words{"register", in("demo/case.angiopose"), "--output", in("first")};
        words.insert(words.end(), more.begin(), more.end());
        const auto first = runCli(words);
        ASSERT_TRUE(first.exitCode == 0 || first.exitCode == 4) << first.messages;
        fs::create_directories(in("elsewhere/deep"));
        fs::rename(in("demo/tree.vtp"), in("elsewhere/vessels.vtp"));
        fs::rename(in("demo/angiogram.dcm"), in("elsewhere/deep/run.dcm"));
        fs::remove_all(in("demo"));
    }

    std::string in(const std::string& name) const { return folder_.file(name); }
    json resultIn(const std::string& folder) const { return json::parse(readText(in(folder + "/result.json"))); }

    const test::TemporaryFolder folder_;
};

TEST_F(CliResult, TellsAllThatItWasFoundFrom)
{
    registerAndScatter({"--set", "searchRollDeg=90"});
    const json result = resultIn("first");
    EXPECT_EQ(result["version"], 2);
    EXPECT_EQ(result["view"], 1);
    EXPECT_LT(result["projection"]["fx"].get<double>(), 0.0);
    EXPECT_EQ(result["projection"]["width"], 512);
    EXPECT_GT(result["geometry"]["sourceToDetectorMm"]["value"].get<double>(), 100.0);
    EXPECT_EQ(result["pose"]["initial"]["cameraFromPatient"].size(), 4U);
    EXPECT_NE(result["pose"]["initial"]["cameraFromPatient"], result["pose"]["cameraFromPatient"]);
    EXPECT_EQ(result["options"]["searchRollDeg"], 90.0);
    EXPECT_EQ(result["inputs"]["angiogram"]["sha256"].get<std::string>().size(), 64U);
    EXPECT_FALSE(result["inputs"]["angiogram"]["dicom"]["sopInstanceUid"].get<std::string>().empty());
    EXPECT_EQ(result["case"]["vessel"]["centerline"]["path"], "tree.vtp");
    EXPECT_EQ(result.dump().find(in("")), std::string::npos);   // folder names may contain patient names
    EXPECT_NE(readText(in("first/overlay.png")).find("\"angiopose-result\""), std::string::npos);
}

TEST_F(CliResult, IsFoundAgainFromItselfAndItsInputsAlone)
{
    registerAndScatter({"--set", "searchRollDeg=90"});
    const auto again =
        runCli({"register", "--from", in("first/result.json"), "--inputs", in("elsewhere"), "--output", in("second")});
    ASSERT_TRUE(again.exitCode == 0 || again.exitCode == 4) << again.messages;
    json first = resultIn("first");
    json second = resultIn("second");
    for (json* each : {&first, &second}) {
        for (const char* key : {"time", "timeMs"}) {
            each->erase(key);
        }
        for (const char* input : {"vessel", "angiogram"}) {   // the files were renamed
            (*each)["inputs"][input].erase("file");
        }
        (*each)["case"]["vessel"]["centerline"].erase("path");
        (*each)["case"]["angiogram"]["image"].erase("path");
    }
    EXPECT_EQ(first, second) << json::diff(first, second).dump();
    EXPECT_EQ(readText(in("first/pose.tfm")), readText(in("second/pose.tfm")));
}

TEST_F(CliResult, IsDrawnFromItselfAndItsInputsAlone)
{
    registerAndScatter({"--deformable"});
    const auto drawn = runCli(
        {"project", "--from", in("first/result.json"), "--inputs", in("elsewhere"), "--output", in("overlay.png")});
    ASSERT_EQ(drawn.exitCode, 0) << drawn.messages;
    EXPECT_GT(fs::file_size(in("overlay.png")), 10000U);
    // The image must equal that of a case at the same pose.
    fs::rename(in("elsewhere/vessels.vtp"), in("first/tree.vtp"));
    fs::rename(in("elsewhere/deep/run.dcm"), in("first/angiogram.dcm"));
    const auto beside = runCli({"project", "--from", in("first/result.json"), "--output", in("beside.png")});
    ASSERT_EQ(beside.exitCode, 0) << beside.messages;
    EXPECT_EQ(readText(in("beside.png")), readText(in("overlay.png")));
}

TEST_F(CliResult, SaysWhichInputIsMissingOrAnother)
{
    registerAndScatter();
    const auto missing = runCli({"register", "--from", in("first/result.json"), "--output", in("second")});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.messages.find("tree.vtp"), std::string::npos) << missing.messages;
    test::writeText(in("first/angiogram.dcm"), "another");
    fs::rename(in("elsewhere/vessels.vtp"), in("first/tree.vtp"));
    const auto other = runCli({"register", "--from", in("first/result.json"), "--output", in("second")});
    EXPECT_EQ(other.exitCode, 3);
    EXPECT_NE(other.messages.find("angiogram.dcm"), std::string::npos) << other.messages;
    EXPECT_EQ(runCli({"register", "--from", in("elsewhere/deep/run.dcm")}).exitCode, 3);
    EXPECT_EQ(runCli({"register"}).exitCode, 2);
    EXPECT_EQ(runCli({"register", "a.angiopose", "--from", in("first/result.json")}).exitCode, 2);
    EXPECT_EQ(runCli({"project", "--output", in("x.png")}).exitCode, 2);
}

TEST_F(CliResult, OfSeveralViewsIsFoundAgain)
{
    ASSERT_EQ(runCli({"simulate", "--seed", "3", "--branches", "8", "--output", in("demo")}).exitCode, 0);
    json session = json::parse(readText(in("demo/case.angiopose")));
    session["views"] = json::array({json{{"path", "case.angiopose"}}});
    test::writeText(in("demo/joint.angiopose"), session.dump());
    runCli({"register", in("demo/joint.angiopose"), "--output", in("first")});
    fs::remove(in("demo/joint.angiopose"));
    fs::remove(in("demo/case.angiopose"));
    for (const std::string from : {"first/joint.json", "first/view-2/result.json"}) {
        fs::remove_all(in("second"));
        const auto again = runCli({"register", "--from", in(from), "--inputs", in("demo"), "--output", in("second")});
        ASSERT_TRUE(again.exitCode == 0 || again.exitCode == 4) << again.messages;
        EXPECT_EQ(test::lastingContentOf(in("second")), test::lastingContentOf(in("first"))) << from;
        EXPECT_EQ(runCli({"project", "--from", in(from), "--inputs", in("demo"), "--output", in("x.png")}).exitCode, 0);
    }
}

}   // namespace
