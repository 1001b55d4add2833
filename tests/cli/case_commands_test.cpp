#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/centerline2d_file.h"
#include "io/pose_file.h"
#include "tests/cli/simulated_case.h"
#include "tests/support/matchers.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::runCli;

class CliOnSimulatedCase : public test::SimulatedCaseTest {};

TEST_F(CliOnSimulatedCase, IsValidAndDescribed)
{
    EXPECT_EQ(runCli({"validate", casePath_}).exitCode, 0);
    const auto info = runCli({"info", casePath_, "--json"});
    ASSERT_EQ(info.exitCode, 0) << info.messages;
    const auto json = nlohmann::json::parse(info.output);
    EXPECT_EQ(json["kind"], "case");
    EXPECT_GT(json["tree"]["points"].get<int>(), 100);
    EXPECT_EQ(json["angiogram"]["geometry"]["sourceToDetectorMm"]["origin"], "header");
    EXPECT_EQ(json["pose"], "at its start");
}

TEST_F(CliOnSimulatedCase, FindsAnInputThatHasMovedAsTheWindowDoes)
{
    fs::create_directory(folder_.file("demo/images"));
    fs::rename(folder_.file("demo/angiogram.dcm"), folder_.file("demo/images/renamed.dcm"));
    const auto info = runCli({"info", casePath_, "--json"});
    ASSERT_EQ(info.exitCode, 0) << info.messages;
    EXPECT_NE(info.output.find("renamed.dcm"), std::string::npos);

    fs::remove(folder_.file("demo/images/renamed.dcm"));
    const auto lost = runCli({"info", casePath_});
    EXPECT_NE(lost.exitCode, 0);
    EXPECT_NE(lost.messages.find("angiogram.dcm"), std::string::npos) << lost.messages;
}

TEST_F(CliOnSimulatedCase, RegistersToTheTruePose)
{
    const auto outcome = runCli({"register", casePath_, "--output", folder_.file("result"), "--json"});
    ASSERT_TRUE(outcome.exitCode == 0) << outcome.exitCode << outcome.messages;
    const auto json = nlohmann::json::parse(outcome.output);   // stdout must contain only JSON
    EXPECT_EQ(json["format"], "angiopose-result");
    EXPECT_GT(json["metrics"]["coverage"].get<double>(),
              0.9);   // half of this tree is unopacified, but all opacified vessels are matched
    EXPECT_TRUE(fs::exists(folder_.file("result/overlay.png")));
    EXPECT_GT(json["timeMs"]["reading"].get<double>(), 0.0);
    EXPECT_GT(json["timeMs"]["tracing"].get<double>(), 0.0);

    const auto found = io::readPose(folder_.file("result/result.json"));
    const auto truth = io::readPose(folder_.file("demo/true-pose.json"));
    ASSERT_TRUE(found && truth);
    EXPECT_TRUE(test::nearPose(found.value(), truth.value(), 0.5, 2.0));   // depth is the least certain
}

TEST_F(CliOnSimulatedCase, ProjectsAGivenPose)
{
    const std::string picture = folder_.file("overlay.png");
    const auto outcome =
        runCli({"project", casePath_, "--pose", folder_.file("demo/true-pose.json"), "--output", picture});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.messages;
    EXPECT_GT(fs::file_size(picture), 10000u);
}

TEST_F(CliOnSimulatedCase, ProjectsBeforeAndAfterWithDepthCueAndSwipe)
{
    const auto sizeOf = [this](const std::vector<std::string>& look) {
        const std::string picture = folder_.file("look.png");
        std::vector<std::string> arguments{"project", casePath_, "--output", picture, "--width", "400"};
        arguments.insert(arguments.end(), look.begin(), look.end());
        const auto outcome = runCli(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.messages;
        return fs::file_size(picture);
    };
    const auto widthPx = [this] {   // of the last written image, from its header
        std::ifstream file(folder_.file("look.png"), std::ios::binary);
        std::array<char, 24> head{};
        file.read(head.data(), head.size());
        return (static_cast<unsigned char>(head[18]) << 8) + static_cast<unsigned char>(head[19]);
    };
    const auto plain = sizeOf({});
    EXPECT_EQ(widthPx(), 400);
    EXPECT_GT(sizeOf({"--before-after"}), plain);
    EXPECT_GT(widthPx(), 800);
    EXPECT_NE(sizeOf({"--depth-cue"}), plain);
    EXPECT_LT(sizeOf({"--swipe", "0"}), plain) << "no vessels at all";
    EXPECT_EQ(runCli({"project", casePath_, "--output", folder_.file("x.png"), "--swipe", "left"}).exitCode, 2);
}

TEST_F(CliOnSimulatedCase, ProjectWritesLinesAndGrayValues)
{
    const std::string drawing = folder_.file("lines.svg");
    ASSERT_EQ(runCli({"project", casePath_, "--output", drawing, "--dpi", "300"}).exitCode, 0);
    const std::string text = test::readText(drawing);
    EXPECT_NE(text.find("<path "), std::string::npos);
    EXPECT_NE(text.find("mm\" height"), std::string::npos);
    EXPECT_NE(text.find("Not for clinical use"), std::string::npos);

    const std::string gray = folder_.file("grey.png");
    ASSERT_EQ(runCli({"project", casePath_, "--output", gray, "--16-bit"}).exitCode, 0);
    EXPECT_EQ(test::readText(gray)[24], 16);   // bit depth, PNG 11.2.2

    const auto refused = runCli({"project", casePath_, "--output", folder_.file("x.pdf")});
    EXPECT_NE(refused.exitCode, 0);
    EXPECT_NE(refused.messages.find(".png or .svg"), std::string::npos) << refused.messages;
}

TEST_F(CliOnSimulatedCase, MeasuresInTheImageAndAlongBranches)
{
    EXPECT_EQ(runCli({"measure", casePath_}).output.find("view,frame,kind,name,value,unit,plane"), 0U);
    std::ifstream file(casePath_);
    nlohmann::json json = nlohmann::json::parse(file);
    json["measurements"] = {
        {{"kind", "length"}, {"plane", "vessels"}, {"pixels", {{100, 100}, {110, 100}}}, {"name", "neck"}}};
    std::ofstream(casePath_) << json;
    const auto measured = runCli({"measure", casePath_});
    EXPECT_EQ(measured.exitCode, 0) << measured.messages;
    EXPECT_NE(measured.output.find("\n1,0,length,neck,"), std::string::npos) << measured.output;

    const std::string table = folder_.file("branches.csv");
    EXPECT_EQ(runCli({"measure", casePath_, "--branches", "--output", table}).exitCode, 0);
    EXPECT_GT(fs::file_size(table), 300U);
    const auto profile = runCli({"measure", casePath_, "--profile", "1"});
    EXPECT_EQ(profile.exitCode, 0) << profile.messages;
    EXPECT_GT(std::ranges::count(profile.output, '\n'), 20);
    const auto none = runCli({"measure", casePath_, "--profile", "9999"});
    EXPECT_EQ(none.exitCode, 3);
    EXPECT_NE(none.messages.find("9999"), std::string::npos);
    EXPECT_EQ(runCli({"measure", casePath_, "--profile", "1", "--branches"}).exitCode, 2);
}

TEST_F(CliOnSimulatedCase, TellsErrorsAtCheckPoints)
{
    std::ifstream file(casePath_);
    nlohmann::json json = nlohmann::json::parse(file);
    json["vessel"]["marks"] = {
        {{"id", 1}, {"kind", "check-point"}, {"name", "fork"}, {"pointInPatientMm", {0.0, 0.0, 0.0}}}};
    json["angiogram"]["frame"] = 0;
    json["sightings"] = {{{"mark", 1}, {"pixel", {100, 100}}, {"frame", 0}}};
    std::ofstream(casePath_) << json;
    const auto table = runCli({"measure", casePath_, "--check-points"});
    EXPECT_EQ(table.exitCode, 0) << table.messages;
    EXPECT_NE(table.output.find("\n1,check-point,fork,0,0,0,,1,"), std::string::npos) << table.output;
    const auto reported = nlohmann::json::parse(runCli({"measure", casePath_, "--check-points", "--json"}).output);
    EXPECT_EQ(reported.at(0).at("views").at(0).at("seenPx").at(0), 100.0);
    EXPECT_EQ(runCli({"measure", casePath_, "--json"}).exitCode, 2);
    const std::string drawn = folder_.file("marked.svg");
    EXPECT_EQ(runCli({"project", casePath_, "--output", drawn}).exitCode, 0);
    std::ifstream svg(drawn);
    EXPECT_NE(std::string(std::istreambuf_iterator<char>(svg), {}).find(">fork"), std::string::npos);
}

TEST_F(CliOnSimulatedCase, TracesItsAngiogram)
{
    const std::string csv = folder_.file("traced.csv");
    const auto outcome = runCli(
        {"trace-angiogram", folder_.file("demo/angiogram.dcm"), "--output", csv, "--mask", folder_.file("mask.png")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.messages;
    EXPECT_GT(fs::file_size(csv), 1000u);
    EXPECT_TRUE(fs::exists(folder_.file("mask.png")));
}

/// Printed frame numbers can be used as arguments: both count from 1, as in DICOM; JSON counts from 0.
TEST_F(CliOnSimulatedCase, FramesCountFromOne)
{
    const std::string run = folder_.file("demo/angiogram.dcm");
    const auto traced = [&](const std::string& frame) {
        return runCli({"trace-angiogram", run, "--frame", frame, "--output", folder_.file("traced.csv")});
    };
    const int count = io::readAngiogram(run).value().frameCount();
    const std::string last = std::to_string(count);
    const auto shown = traced(last);
    EXPECT_EQ(shown.exitCode, 0) << shown.messages;
    EXPECT_EQ(shown.output.find("frame " + last + " of " + last + ":"), 0U) << shown.output;
    for (const std::string beyond : {"0", "-3", "99"}) {
        const auto refused = traced(beyond);
        EXPECT_EQ(refused.exitCode, 3);
        EXPECT_NE(refused.messages.find("The run has frames 1 to " + last), std::string::npos) << refused.messages;
    }
    const auto registered = runCli({"register", casePath_, "--frame", "5", "--output", folder_.file("out")});
    ASSERT_TRUE(registered.exitCode == 0 || registered.exitCode == 4) << registered.messages;
    EXPECT_EQ(nlohmann::json::parse(test::readText(folder_.file("out/result.json")))["inputs"]["frame"], 4);
}

TEST_F(CliOnSimulatedCase, TraceAngiogramWritesWhatMayBeADeviceApart)
{
    const std::string run = folder_.file("demo/angiogram.dcm");
    const auto pointsIn = [this](const std::string& name) {
        const auto curves = io::readCenterline2d(folder_.file(name));
        return curves ? curves.value().pointCount() : 0;
    };
    ASSERT_EQ(runCli({"trace-angiogram", run, "--output", folder_.file("all.csv")}).exitCode, 0);
    const auto apart =
        runCli({"trace-angiogram", run, "--output", folder_.file("rest.csv"), "--apart", folder_.file("devices.csv")});
    EXPECT_EQ(apart.exitCode, 0) << apart.messages;
    EXPECT_NE(apart.output.find("devices.csv"), std::string::npos) << "the demo has a catheter: " << apart.output;
    EXPECT_GT(pointsIn("devices.csv"), 20U);
    EXPECT_EQ(pointsIn("rest.csv") + pointsIn("devices.csv"), pointsIn("all.csv"));
}

TEST_F(CliOnSimulatedCase, TraceAngiogramSubtractsAndComposes)
{
    const std::string run = folder_.file("demo/angiogram.dcm");
    const std::string csv = folder_.file("trace.csv");
    const auto composed = runCli({"trace-angiogram", run, "--composite", "minimum", "--output", csv});
    EXPECT_EQ(composed.exitCode, 0) << composed.messages;
    EXPECT_NE(composed.output.find("all frames"), std::string::npos);
    const auto subtracted =
        runCli({"trace-angiogram", run, "--mask-frames", "1", "--mask-shift", "0,0", "--output", csv});
    EXPECT_EQ(subtracted.exitCode, 0) << subtracted.messages;
    EXPECT_NE(subtracted.output.find("mean of frames 1\n"), std::string::npos);
    EXPECT_EQ(runCli({"trace-angiogram", run, "--mask-frames", "99", "--output", csv}).exitCode, 3);
    EXPECT_EQ(runCli({"trace-angiogram", run, "--composite", "sum", "--output", csv}).exitCode, 2);
}

TEST_F(CliOnSimulatedCase, UnknownMethodsAndOptionsAreUsageErrors)
{
    EXPECT_EQ(runCli({"register", casePath_, "--method", "magic"}).exitCode, 2);
    const auto option = runCli({"register", casePath_, "--set", "magic=1"});
    EXPECT_EQ(option.exitCode, 2);
    EXPECT_NE(option.messages.find("magic"), std::string::npos);
}

TEST_F(CliOnSimulatedCase, KeepsLockedDegreesOfFreedom)
{
    const auto outcome =
        runCli({"register", casePath_, "--lock", "lao-rao,cra-cau,roll", "--output", folder_.file("locked"), "--json"});
    ASSERT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.exitCode << outcome.messages;
    const auto found = io::readPose(folder_.file("locked/result.json"));
    core::Messages warnings;
    const auto loaded = io::loadCase(casePath_, warnings);
    ASSERT_TRUE(found && loaded);
    EXPECT_LT((found.value().rotation - loaded.value().shown().cameraFromPatient.rotation).norm(), 1e-12);
    EXPECT_GT((found.value().translation - loaded.value().shown().cameraFromPatient.translation).norm(), 0.1);

    const auto unknown = runCli({"register", casePath_, "--lock", "sideways"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.messages.find("along-ray"), std::string::npos);
    EXPECT_EQ(runCli({"register", casePath_, "--method", "assembled-icp", "--lock", "roll"}).exitCode, 2);
}

/// Writes the case with only a guidewire in its image, 1 mm beside a quarter of the longest branch. The stated position
/// is less certain than the true one: other branches may contain it as well.
std::string wireCase(const std::string& casePath, const core::RigidTransform& truth, const std::string& path)
{
    core::Messages warnings;
    core::Case session = io::loadCase(casePath, warnings).value();
    core::VesselTree tree = *session.vessels.tree;
    std::ranges::sort(tree.branches, std::ranges::greater(), &core::VesselBranch::lengthMm);
    const core::ProjectionCamera camera = core::cameraOf(session.shown()).value();
    core::Curve2d wire;
    const std::vector<Eigen::Vector3d>& course = tree.branches.front().pointsInPatient;
    for (const Eigen::Vector3d& point : std::span(course).first(course.size() / 4)) {
        const Eigen::Vector3d beside = point + Eigen::Vector3d(1.0, 0.0, 0.0);
        wire.pointsPx.push_back(*core::project(camera, truth * beside));
    }
    core::Centerline2d centerline;
    centerline.curves = {wire};
    session.shown().target.centerline = std::make_shared<const core::Centerline2d>(std::move(centerline));
    session.shown().target.editedFrame = session.shown().frame;
    session.shown().cameraFromPatient = truth;
    session.shown().cameraFromPatient.translation += Eigen::Vector3d(2.0, -1.5, 3.0);
    session.options.method = "wire";
    session.options.wire.lateralMm = 20.0;
    session.options.wire.offAxisMm = 4.0;
    EXPECT_TRUE(io::saveCase(session, path));
    return path;
}

TEST_F(CliOnSimulatedCase, RanksTheWaysOfAWireAndTakesTheOneAskedFor)
{
    const auto truth = io::readPose(folder_.file("demo/true-pose.json"));
    ASSERT_TRUE(truth);
    const std::string path = wireCase(casePath_, truth.value(), folder_.file("demo/wire.angiopose"));
    const auto words = runCli({"register", path, "--output", folder_.file("wire")});
    ASSERT_TRUE(words.exitCode == 0 || words.exitCode == 4) << words.exitCode << words.messages;
    EXPECT_NE(words.output.find("path taken"), std::string::npos) << words.output;
    EXPECT_NE(words.output.find("of the guidewire along these branches"), std::string::npos) << words.output;

    const auto first =
        nlohmann::json::parse(runCli({"register", path, "--output", folder_.file("wire"), "--json"}).output);
    ASSERT_TRUE(first.contains("ways"));
    EXPECT_EQ(first["method"], "wire");
    const auto& ways = first["ways"];
    ASSERT_FALSE(ways.empty());
    EXPECT_EQ(ways[0]["cameraFromPatient"], first["pose"]["cameraFromPatient"]);
    EXPECT_FALSE(ways[0]["branches"].empty());
    EXPECT_EQ(first["alternatives"].size() + 1, ways.size());
    ASSERT_GT(ways.size(), 1U);
    const auto second = nlohmann::json::parse(
        runCli({"register", path, "--set", "wireWay=2", "--output", folder_.file("wire2"), "--json"}).output);
    EXPECT_EQ(second["ways"][0]["branches"], ways[1]["branches"]);
    EXPECT_EQ(second["pose"]["cameraFromPatient"], ways[1]["cameraFromPatient"]);
}

TEST_F(CliOnSimulatedCase, InputsAreNeverOverwritten)
{
    const auto before = fs::last_write_time(folder_.file("demo/angiogram.dcm"));
    runCli({"register", casePath_, "--output", folder_.file("demo")});
    EXPECT_EQ(fs::last_write_time(folder_.file("demo/angiogram.dcm")), before);
    EXPECT_EQ(runCli({"validate", casePath_}).exitCode, 0);
}

}   // namespace
