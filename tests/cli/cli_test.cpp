#include "core/simulation/simulated_case.h"
#include "io/case_file.h"
#include "io/pose_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/cli/run_program.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/matchers.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using test::runCli;

using test::TemporaryFolder;
using test::writeText;

TEST(Cli, HelpAndVersionSucceed)
{
    EXPECT_EQ(runCli({"--version"}).exitCode, 0);
    const auto help = runCli({"register", "--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_NE(help.output.find("Example:"), std::string::npos);
    EXPECT_NE(help.output.find("dynaweight"), std::string::npos);
}

TEST(Cli, WrongUsageGivesTwo)
{
    EXPECT_EQ(runCli({}).exitCode, 2);
    EXPECT_EQ(runCli({"dance"}).exitCode, 2);
    EXPECT_EQ(runCli({"register"}).exitCode, 2);
    EXPECT_EQ(runCli({"simulate", "--seed", "many", "--output", "x"}).exitCode, 2);
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
    const TemporaryFolder folder;
    const std::string path = folder.file("case.angiopose");
    for (const std::string text :
         {"", "{", "[]", "{\"format\": \"something\"}", "{\"format\": \"angiopose-case\", \"version\": 99}",
          "{\"format\": \"angiopose-case\", \"version\": 1, \"vessel\": 3}"}) {
        writeText(path, text);
        EXPECT_EQ(runCli({"validate", path}).exitCode, 3) << text;
        const auto outcome = runCli({"register", path, "--output", folder.file("result")});
        EXPECT_EQ(outcome.exitCode, 3) << text;
        EXPECT_NE(outcome.messages.find(path), std::string::npos) << text;
    }
}

class CliOnSimulatedCase : public ::testing::Test {
protected:
    void SetUp() override
    {
        const auto simulated = runCli({"simulate", "--seed", "3", "--output", folder_.file("demo")});
        ASSERT_EQ(simulated.exitCode, 0) << simulated.messages;
        casePath_ = folder_.file("demo/case.angiopose");
    }

    TemporaryFolder folder_;
    std::string casePath_;
};

TEST_F(CliOnSimulatedCase, IsValidAndDescribed)
{
    EXPECT_EQ(runCli({"validate", casePath_}).exitCode, 0);
    const auto info = runCli({"info", casePath_, "--json"});
    ASSERT_EQ(info.exitCode, 0) << info.messages;
    const auto json = nlohmann::json::parse(info.output);
    EXPECT_EQ(json["kind"], "case");
    EXPECT_GT(json["tree"]["points"].get<int>(), 100);
    EXPECT_EQ(json["angiogram"]["geometry"]["sourceToDetectorMm"]["origin"], "header");
}

TEST_F(CliOnSimulatedCase, RegistersToTheTruePose)
{
    const auto outcome = runCli({"register", casePath_, "--output", folder_.file("result"), "--json"});
    ASSERT_TRUE(outcome.exitCode == 0) << outcome.exitCode << outcome.messages;
    const auto json = nlohmann::json::parse(outcome.output);   // stdout holds JSON and nothing else
    EXPECT_EQ(json["format"], "angiopose-result");
    EXPECT_GT(json["metrics"]["coverage"].get<double>(),
              0.9);   // half of this tree is unfilled, but all that is is met
    EXPECT_TRUE(fs::exists(folder_.file("result/overlay.png")));

    const auto found = io::readPose(folder_.file("result/result.json"));
    const auto truth = io::readPose(folder_.file("demo/true-pose.json"));
    ASSERT_TRUE(found && truth);
    EXPECT_TRUE(test::nearPose(found.value(), truth.value(), 0.5, 2.0));   // the depth is the weakest
}

TEST_F(CliOnSimulatedCase, ProjectsAGivenPose)
{
    const std::string picture = folder_.file("overlay.png");
    const auto outcome =
        runCli({"project", casePath_, "--pose", folder_.file("demo/true-pose.json"), "--output", picture});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.messages;
    EXPECT_GT(fs::file_size(picture), 10000u);
}

TEST_F(CliOnSimulatedCase, TracesItsAngiogram)
{
    const std::string csv = folder_.file("traced.csv");
    const auto outcome = runCli(
        {"trace-angiogram", folder_.file("demo/angiogram.dcm"), "--output", csv, "--mask", folder_.file("mask.png")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.messages;
    EXPECT_GT(fs::file_size(csv), 1000u);
    EXPECT_TRUE(fs::exists(folder_.file("mask.png")));
    EXPECT_EQ(
        runCli({"trace-angiogram", folder_.file("demo/angiogram.dcm"), "--frame", "99", "--output", csv}).exitCode, 3);
}

TEST_F(CliOnSimulatedCase, TraceAngiogramSubtractsAndComposes)
{
    const std::string run = folder_.file("demo/angiogram.dcm");
    const std::string csv = folder_.file("trace.csv");
    const auto composed = runCli({"trace-angiogram", run, "--composite", "minimum", "--output", csv});
    EXPECT_EQ(composed.exitCode, 0) << composed.messages;
    EXPECT_NE(composed.output.find("all frames"), std::string::npos);
    const auto subtracted =
        runCli({"trace-angiogram", run, "--mask-frames", "0", "--mask-shift", "0,0", "--output", csv});
    EXPECT_EQ(subtracted.exitCode, 0) << subtracted.messages;
    EXPECT_NE(subtracted.output.find("mean of frames 0"), std::string::npos);
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
    std::vector<std::string> warnings;
    const auto loaded = io::loadCase(casePath_, warnings);
    ASSERT_TRUE(found && loaded);
    EXPECT_LT((found.value().rotation - loaded.value().cameraFromPatient.rotation).norm(), 1e-12);
    EXPECT_GT((found.value().translation - loaded.value().cameraFromPatient.translation).norm(), 0.1);

    const auto unknown = runCli({"register", casePath_, "--lock", "sideways"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.messages.find("along-ray"), std::string::npos);
    EXPECT_EQ(runCli({"register", casePath_, "--method", "assembled-icp", "--lock", "roll"}).exitCode, 2);
}

TEST_F(CliOnSimulatedCase, InputsAreNeverOverwritten)
{
    const auto before = fs::last_write_time(folder_.file("demo/angiogram.dcm"));
    runCli({"register", casePath_, "--output", folder_.file("demo")});
    EXPECT_EQ(fs::last_write_time(folder_.file("demo/angiogram.dcm")), before);
    EXPECT_EQ(runCli({"validate", casePath_}).exitCode, 0);
}

TEST(Cli, ConvertsBetweenFormatsOfOneKind)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(io::writeVolume(test::forkScan(), folder.file("scan.nrrd")));
    ASSERT_EQ(runCli({"convert", folder.file("scan.nrrd"), folder.file("scan.nii.gz")}).exitCode, 0);
    const auto volume = io::readVolume(folder.file("scan.nii.gz"));
    ASSERT_TRUE(volume) << volume.error().message;
    EXPECT_EQ(volume.value().volume.voxels, test::forkScan().voxels);

    writeText(folder.file("tree.csv"), "x,y,z,radius,branch\n0,0,0,1,4\n9,0,0,1,4\n20,5,0,2,4\n");
    ASSERT_EQ(runCli({"convert", folder.file("tree.csv"), folder.file("tree.mrk.json")}).exitCode, 0);
    ASSERT_EQ(runCli({"convert", folder.file("tree.mrk.json"), folder.file("back.vtp")}).exitCode, 0);
    const auto tree = io::readVesselTree(folder.file("back.vtp"));
    ASSERT_TRUE(tree) << tree.error().message;
    EXPECT_EQ(tree.value().branches.front().pointsInPatient.back(), Eigen::Vector3d(20, 5, 0));

    writeText(folder.file("curve.csv"), "x,y,branch\n1,2,0\n3,4,0\n");
    EXPECT_EQ(runCli({"convert", folder.file("curve.csv"), folder.file("copy.csv")}).exitCode, 0);
    EXPECT_EQ(runCli({"convert", folder.file("tree.csv"), folder.file("tree.nii.gz")}).exitCode, 3);
    EXPECT_EQ(runCli({"convert", folder.file("tree.csv"), folder.file("tree.doc")}).exitCode, 3);
    EXPECT_EQ(runCli({"convert", folder.file("tree.csv"), folder.file("tree.csv")}).exitCode, 3) << "itself";
    const auto advice = runCli({"convert", folder.file("scan.nrrd"), folder.file("tree.vtp")});
    EXPECT_EQ(advice.exitCode, 3);
    EXPECT_NE(advice.messages.find("trace-vessel"), std::string::npos);
}

TEST(Cli, ConvertsDicomSegmentationsAndPackedScans)
{
    ANGIOPOSE_NEEDS_DATA("exotic-dicom");
    const TemporaryFolder folder;
    const auto segmentation = test::dataFile("exotic-dicom/pydicom-data/liver_nonbyte_aligned.dcm").string();
    const auto converted = runCli({"convert", segmentation, folder.file("liver.nii.gz")});
    ASSERT_EQ(converted.exitCode, 0) << converted.messages;
    const auto labels = io::readLabels(folder.file("liver.nii.gz"));
    ASSERT_TRUE(labels) << labels.error().message;
    const auto direct = io::readLabels(segmentation);
    ASSERT_TRUE(direct) << direct.error().message;
    EXPECT_EQ(labels.value().voxels, direct.value().voxels);
    EXPECT_GT(std::count(direct.value().voxels.begin(), direct.value().voxels.end(), 1), 100);

    const auto packed = test::dataFile("exotic-dicom/nibabel/philips_mprage.dcm.gz").string();
    EXPECT_EQ(runCli({"convert", packed, folder.file("head.nrrd")}).exitCode, 0);
}

TEST(Cli, DescribesVolumesFoldersAndSurfaces)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), folder.file("mask.nii.gz")));
    const auto volume = runCli({"info", folder.file("mask.nii.gz"), "--json"});
    ASSERT_EQ(volume.exitCode, 0) << volume.messages;
    const auto json = nlohmann::json::parse(volume.output);
    EXPECT_EQ(json["kind"], "label image");
    EXPECT_EQ(json["geometry"]["size"], nlohmann::json({64, 40, 96}));
    EXPECT_EQ(json["geometry"]["axesRunTo"], nlohmann::json({"left", "back", "head"}));

    fs::create_directory(folder.file("ct"));
    for (int k = 0; k < 5; ++k) {
        test::CtSlice slice;
        slice.sopInstanceUid = "1.2.3." + std::to_string(k);
        slice.position = {0, 0, k < 3 ? 2.0 * k : 2.0 * k + 2.0};
        slice.pixels.assign(72, 0);
        writeText(folder.file("ct/" + std::to_string(k)), test::ctSlice(slice));
    }
    const auto listed = runCli({"info", folder.file("ct"), "--json"});
    ASSERT_EQ(listed.exitCode, 0) << listed.messages;
    const auto series = nlohmann::json::parse(listed.output)["series"];
    ASSERT_EQ(series.size(), 1U);
    EXPECT_EQ(series[0]["geometry"]["size"], nlohmann::json({8, 9, 6}));
    EXPECT_NE(series[0]["warnings"][0].get<std::string>().find("missing"), std::string::npos);
    EXPECT_NE(runCli({"info", folder.file("ct")}).output.find("CTA 0.75"), std::string::npos);
}

TEST(Cli, TracesALabelImageToATree)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), folder.file("mask.nii.gz")));
    const auto traced = runCli({"trace-vessel", folder.file("mask.nii.gz"), "--labels", "2", "--root", "0,0,0",
                                "--output", folder.file("tree.vtp"), "--mask", folder.file("lumen.nii.gz")});
    ASSERT_EQ(traced.exitCode, 0) << traced.messages;
    const auto tree = io::readVesselTree(folder.file("tree.vtp"));
    ASSERT_TRUE(tree) << tree.error().message;
    EXPECT_EQ(test::endsOf(tree.value()), 3);
    EXPECT_TRUE(io::readLabels(folder.file("lumen.nii.gz")));
    EXPECT_EQ(runCli({"trace-vessel", folder.file("tree.vtp"), "--output", folder.file("x.vtp")}).exitCode, 3);
}

/// Every odd, malformed or truncated file: a load or one clear message, quickly and in little memory.
TEST(Cli, ExoticFilesLoadOrAreRefusedClearly)
{
    ANGIOPOSE_NEEDS_DATA("exotic-dicom");
    int files = 0;
    for (const std::string folder :
         {"exotic-dicom", "exotic-lfs-pointers", "exotic-mesh", "exotic-nifti", "exotic-nrrd"}) {
        for (const auto& entry : fs::recursive_directory_iterator(test::dataFile(folder))) {
            if (!entry.is_regular_file()) {
                continue;
            }
            ++files;
            const std::string path = entry.path().string();
            const auto outcome = runCli({"info", path});
            EXPECT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 3) << path << ": " << outcome.exitCode;
            EXPECT_LT(outcome.seconds, 10.0) << path;
            EXPECT_LT(outcome.peakMemoryKiB, 1024 * 1024) << path;
            if (outcome.exitCode == 3) {
                EXPECT_EQ(std::count(outcome.messages.begin(), outcome.messages.end(), '\n'), 1) << outcome.messages;
                EXPECT_NE(outcome.messages.find(entry.path().filename().string()), std::string::npos)
                    << outcome.messages;
            }
        }
    }
    EXPECT_GT(files, 100);
}

TEST(Cli, InfoTellsEveryGeometryTagAndWhatFollows)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A/IM3.dcm");
    const std::string image = test::dataFile("coronary-phantom-xa/views-A/IM3.dcm").string();
    const auto geometry = nlohmann::json::parse(runCli({"info", image, "--json"}).output)["geometry"];
    EXPECT_EQ(geometry["columnSpacingMm"]["origin"], "derived");
    EXPECT_EQ(geometry["header"]["(0018,1111) Distance Source to Patient"], "720");
    EXPECT_NEAR(geometry["magnification"].get<double>(), 891.0 / 720.0, 1e-12);
    EXPECT_TRUE(geometry["contradictions"].empty());
    const auto readable = runCli({"info", image});
    EXPECT_NE(readable.output.find("Positioner Primary Angle: -0.8"), std::string::npos) << readable.output;
    EXPECT_NE(readable.output.find("as from the detector"), std::string::npos);
}

TEST(Cli, ValidateWarnsOfGeometryThatMakesNoSense)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    const fs::path phantom = test::dataFile("coronary-phantom-xa");
    writeText(folder.file("case.angiopose"),
              R"({"format": "angiopose-case", "version": 1, "vessel": {"centerline": {"path": ")" +
                  (phantom / "tree/Centerlines.vtk").string() + R"("}}, "angiogram": {"image": {"path": ")" +
                  (phantom / "views-A/IM3.dcm").string() + R"("}}, "geometry": {"sourceToPatientMm": 900}})");
    const auto outcome = runCli({"validate", folder.file("case.angiopose")});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.messages.find("behind the detector"), std::string::npos);
}

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

TEST(Cli, RegistersTheViewsThatStandInACase)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    const fs::path cases = test::dataFile("coronary-phantom-xa/cases");
    std::vector<std::string> warnings;
    core::RegistrationCase both = io::loadCase((cases / "IM3.angiopose").string(), warnings).value();
    both.otherViews = {{{},
                        std::make_shared<const core::RegistrationCase>(
                            io::loadCase((cases / "IM4.angiopose").string(), warnings).value())}};
    ASSERT_TRUE(io::saveCase(both, folder.file("both.angiopose")));
    const auto outcome =
        runCli({"register", folder.file("both.angiopose"), "--output", folder.file("joint"), "--json"});
    ASSERT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.messages;
    EXPECT_EQ(nlohmann::json::parse(outcome.output)["views"].size(), 2U);
    EXPECT_TRUE(fs::exists(fs::path(folder.file("joint")) / "view-2/result.json"));
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

}   // namespace
