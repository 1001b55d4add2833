#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/pose_file.h"
#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::runCli;
using test::TemporaryFolder;

TEST(Cli, RegistersTwoViewsTogether)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    const fs::path cases = test::dataFile("coronary-phantom-xa/cases");
    const auto outcome = runCli({"register", (cases / "IM3.angiopose").string(), "--view",
                                 (cases / "IM4.angiopose").string(), "--output", folder.file("joint"), "--json"});
    ASSERT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.messages;
    const auto joint = nlohmann::json::parse(outcome.output);
    ASSERT_EQ(joint["views"].size(), 2U);
    for (const auto& view : joint["views"]) {
        EXPECT_LT(view["metrics"]["medianProjectionDistancePx"].get<double>(), 5.0);
    }
    EXPECT_EQ(joint["views"][0]["geometryCorrection"]["turnDeg"], 0.0);
    EXPECT_LT(joint["views"][1]["geometryCorrection"]["turnDeg"].get<double>(), 2.0);
    const auto alone =
        runCli({"register", (cases / "IM3.angiopose").string(), "--output", folder.file("alone"), "--json"});
    EXPECT_LT(joint["uncertainty"]["depthSigmaMm"].get<double>(),
              nlohmann::json::parse(alone.output)["uncertainty"]["depthSigmaMm"].get<double>());
    for (const char* name : {"joint.json", "result.json", "overlay.png", "view-2/result.json", "view-2/pose.tfm"}) {
        EXPECT_TRUE(fs::exists(fs::path(folder.file("joint")) / name)) << name;
    }
}

void setPatient(const std::string& imagePath, const std::string& number)
{
    core::Angiogram run = io::readAngiogram(imagePath).value();
    run.identity.patientId = number;
    ASSERT_TRUE(io::writeAngiogram(run, imagePath));
}

TEST(Cli, TrustsNoFitWithTheViewOfAnotherPatientUnlessSomebodyMadeSure)
{
    const TemporaryFolder folder;
    for (const char* view : {"a", "b"}) {
        ASSERT_EQ(runCli({"simulate", "--seed", "5", "--branches", "8", "--output", folder.file(view)}).exitCode, 0);
    }
    setPatient(folder.file("a/angiogram.dcm"), "0815");
    setPatient(folder.file("b/angiogram.dcm"), "4711");
    const std::vector<std::string> command{"register", folder.file("a/case.angiopose"),
                                           "--view",   folder.file("b/case.angiopose"),
                                           "--output", folder.file("out")};
    const auto outcome = runCli(command);
    EXPECT_EQ(outcome.exitCode, 4) << outcome.messages;
    EXPECT_NE(outcome.messages.find("different patients"), std::string::npos) << outcome.messages;
    EXPECT_TRUE(outcome.output.starts_with("trustworthy    NO: NOT RELIABLE")) << outcome.output;
    EXPECT_LT(outcome.output.find("different patients"), outcome.output.find("method"));
    for (const char* name : {"out/joint.json", "out/result.json", "out/view-2/result.json"}) {
        EXPECT_FALSE(nlohmann::json::parse(test::readText(folder.file(name)))["trustworthy"].get<bool>()) << name;
    }
    std::vector<std::string> sure = command;
    sure.insert(sure.end(), {"--same-patient", "--save", folder.file("sure.angiopose")});
    const auto made = runCli(sure);
    EXPECT_EQ(made.exitCode, 0) << made.output;
    EXPECT_EQ(runCli({"register", folder.file("sure.angiopose")}).exitCode, 0) << "the case keeps the answer";
    EXPECT_NE(made.messages.find("different patients"), std::string::npos) << "the warning remains";
}

TEST(Cli, RefusesToDrawVesselsBehindTheSource)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runCli({"simulate", "--seed", "5", "--branches", "8", "--output", folder.file("demo")}).exitCode, 0);
    const auto drawn = [&folder](double x, double z) {
        core::RigidTransform pose;
        pose.translation = {x, 0.0, z};
        EXPECT_TRUE(io::writePose(pose, folder.file("pose.json")));
        return runCli({"project", folder.file("demo/case.angiopose"), "--pose", folder.file("pose.json"), "--output",
                       folder.file("seen.png")});
    };
    const auto behind = drawn(0.0, -2000.0);
    EXPECT_EQ(behind.exitCode, 3);
    EXPECT_NE(behind.messages.find("behind the X-ray source"), std::string::npos) << behind.messages;
    EXPECT_FALSE(fs::exists(folder.file("seen.png")));
    const auto aside = drawn(5000.0, 2000.0);
    EXPECT_EQ(aside.exitCode, 0) << aside.messages;
    EXPECT_NE(aside.messages.find("no vessel lies inside the image"), std::string::npos) << aside.messages;
}

TEST(Cli, DeformationsTheVesselsOnRequest)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runCli({"simulate", "--seed", "5", "--non-rigid", "3", "--output", folder.file("demo")}).exitCode, 0);
    const auto outcome = runCli({"register", (fs::path(folder.file("demo")) / "case.angiopose").string(),
                                 "--deformable", "--output", folder.file("bent"), "--json"});
    ASSERT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.messages;
    const auto deformed = nlohmann::json::parse(outcome.output)["deformable"];
    EXPECT_TRUE(deformed["verdict"] == "bent" || deformed["verdict"] == "unsure" || deformed["verdict"] == "rigid");
    EXPECT_FALSE(deformed["perBranch"].empty());
    for (const char* name : {"result.json", "bent.vtp", "motion.csv", "overlay.png"}) {
        EXPECT_TRUE(fs::exists(fs::path(folder.file("bent")) / name)) << name;
    }
}

TEST(Cli, RegistersTheViewsThatStandInACase)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    const fs::path cases = test::dataFile("coronary-phantom-xa/cases");
    core::Messages warnings;
    core::Case both = io::loadCase((cases / "IM3.angiopose").string(), warnings).value();
    both.views.push_back(io::loadCase((cases / "IM4.angiopose").string(), warnings).value().shown());
    ASSERT_TRUE(io::saveCase(both, folder.file("both.angiopose")));
    const auto outcome =
        runCli({"register", folder.file("both.angiopose"), "--output", folder.file("joint"), "--json"});
    ASSERT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.messages;
    EXPECT_EQ(nlohmann::json::parse(outcome.output)["views"].size(), 2U);
    EXPECT_TRUE(fs::exists(fs::path(folder.file("joint")) / "view-2/result.json"));

    // A batch does the same.
    const std::string manifest = folder.write("batch.csv", "case,name\nboth.angiopose,both\n");
    const auto batch = runCli({"batch", manifest, "--output", folder.file("out")});
    ASSERT_TRUE(batch.exitCode == 0 || batch.exitCode == 4) << batch.messages;
    EXPECT_EQ(test::readText(folder.file("out/both/pose.tfm")), test::readText(folder.file("joint/pose.tfm")));
    const auto joint = nlohmann::json::parse(test::readText(folder.file("out/both/joint.json")));
    const auto own = nlohmann::json::parse(test::readText(folder.file("out/both/result.json")));
    EXPECT_EQ(joint["uncertainty"]["depthSigmaMm"], own["uncertainty"]["depthSigmaMm"]);
}

TEST(Cli, FollowsTheVesselsThroughTheFramesOfARun)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    const std::string path = test::dataFile("coronary-phantom-xa/cases/IM4.angiopose").string();
    const auto outcome = runCli({"track", path, "--output", folder.file("poses.csv")});
    ASSERT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.messages;
    const std::string table = test::readText(folder.file("poses.csv"));
    EXPECT_EQ(std::ranges::count(table, '\n'), 11) << table;   // header and ten frames
    EXPECT_TRUE(table.starts_with("frame,trustworthy,searched,score,r11"));
    EXPECT_EQ(runCli({"track", path, "--keep-pose"}).exitCode, 2);   // no --output
}

TEST(Cli, DoesNotFollowAgainWhatTheCaseKeeps)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runCli({"simulate", "--seed", "3", "--output", folder.file("demo")}).exitCode, 0);
    core::Messages warnings;
    core::Case session = io::loadCase(folder.file("demo/case.angiopose"), warnings).value();
    core::View& view = session.shown();
    std::vector<core::TrackedRunFrame> frames(static_cast<std::size_t>(view.angiogram->frameCount()));
    for (std::size_t k = 0; k < frames.size(); ++k) {
        frames[k].frame = static_cast<int>(k);
        frames[k].tracked = {view.cameraFromPatient, 0.125, false, true, {}};
    }
    view.followed = core::makeTrackedRun(view.frame, frames);
    ASSERT_TRUE(io::saveCase(session, folder.file("demo/whole.angiopose")));
    frames.pop_back();
    view.followed = core::makeTrackedRun(view.frame, frames);
    ASSERT_TRUE(io::saveCase(session, folder.file("demo/stopped.angiopose")));

    const auto scoresOf = [&folder](const std::string& name) {
        const std::string table = folder.file(name + ".csv");
        const auto outcome =
            runCli({"track", folder.file("demo/" + name + ".angiopose"), "--keep-pose", "--output", table});
        EXPECT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.messages;
        return test::readText(table);
    };
    EXPECT_NE(scoresOf("whole").find("7,1,0,0.125,"), std::string::npos);
    EXPECT_EQ(scoresOf("stopped").find(",0.125,"), std::string::npos) << "one frame is not known";
}

TEST(Cli, TellsWhichAnglesShowABranch)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runCli({"simulate", "--seed", "3", "--output", folder.file("demo")}).exitCode, 0);
    const std::string path = folder.file("demo/case.angiopose");
    const auto outcome = runCli(
        {"angles", path, "--branch", "2", "--primary", "-30", "45", "--output", folder.file("angles.csv"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    const auto answer = nlohmann::json::parse(outcome.output);
    const auto costOf = [](const nlohmann::json& each) {
        return each["foreshortening"].get<double>() + each["overlap"].get<double>();
    };
    ASSERT_FALSE(answer["best"].empty());
    EXPECT_LE(costOf(answer["best"][0]), costOf(answer["now"]));
    EXPECT_GE(answer["best"][0]["primaryAngleDeg"], -30.0);
    EXPECT_LE(answer["best"][0]["primaryAngleDeg"], 45.0);
    EXPECT_EQ(std::ranges::count(test::readText(folder.file("angles.csv")), '\n'), 1 + 31 * 33);

    EXPECT_NE(runCli({"angles", path, "--branch", "2"}).output.find("best"), std::string::npos);
    EXPECT_EQ(runCli({"angles", path, "--branch", "99"}).exitCode, 3);
    EXPECT_EQ(runCli({"angles", path, "--branch", "2", "--primary", "40", "-40"}).exitCode, 3);
    EXPECT_EQ(runCli({"angles", path}).exitCode, 2);
}

}   // namespace
