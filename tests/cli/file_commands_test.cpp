#include "io/centerline2d_file.h"
#include "io/image_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/cli/run_program.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/drawn_tubes.h"
#include "tests/support/for_each.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::runCli;
using test::TemporaryFolder;
using test::writeText;

TEST(Cli, NumbersThatAreNoneAreRefusedByTheOptionsName)
{
    const std::vector<std::vector<std::string>> commands = {
        {"convert", "a.obj", "b.stl", "--unit-mm"},
        {"convert", "a.obj", "b.nii", "--spacing-mm"},
        {"convert", "a.json", "b.json", "--pose-to", "diffdrr", "--source-to-detector"},
        {"trace-vessel", "a.nii", "--output", "b.vtp", "--threshold"},
        {"trace-vessel", "a.nii", "--output", "b.vtp", "--point-spacing"},
        {"simulate", "--seed", "1", "--output", "x", "--non-rigid"}};
    for (const std::vector<std::string>& command : commands) {
        for (const char* number : {"nan", "inf", "-inf", "NaN"}) {
            std::vector<std::string> arguments = command;
            arguments.back() += std::string("=") + number;
            const auto outcome = runCli(arguments);
            EXPECT_EQ(outcome.exitCode, 2) << arguments.back();
            EXPECT_NE(outcome.messages.find(command.back()), std::string::npos) << outcome.messages;
        }
    }
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

TEST(Cli, TracesEveryPieceOfAMaskAndNamesTheSeeds)
{
    const TemporaryFolder folder;
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {60, 40, 60}, {1, 1, 1});
    const core::VoxelMask mask =
        test::drawnMask(grid, {{{-15, 0, -22}, {-15, 0, 22}, 3.0}, {{15, 0, -15}, {15, 0, 15}, 2.0}});
    core::LabelVolume labels(grid);
    std::ranges::copy(mask.voxels, labels.voxels.begin());
    const std::string file = folder.file("mask.nii.gz");
    ASSERT_TRUE(io::writeLabels(labels, file));
    const auto trace = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"trace-vessel", file, "--output", folder.file("tree.vtp")};
        words.insert(words.end(), more.begin(), more.end());
        return runCli(words);
    };
    const auto all = trace({});
    ASSERT_EQ(all.exitCode, 0) << all.messages;
    EXPECT_NE(all.messages.find("2 unconnected components"), std::string::npos) << all.messages;
    EXPECT_NE(all.output.find(": 2 branches"), std::string::npos) << all.output;
    const std::size_t second = all.output.find("component 2: ");
    ASSERT_NE(second, std::string::npos) << all.output;
    const std::size_t seed = all.output.find("--seed=", second);
    ASSERT_NE(seed, std::string::npos);
    const std::string ready = all.output.substr(seed, all.output.find('\n', seed) - seed);
    const auto one = trace({ready});
    ASSERT_EQ(one.exitCode, 0) << ready << one.messages;
    EXPECT_NE(one.output.find(": 1 branch, 3"), std::string::npos) << one.output;
    EXPECT_NE(one.output.find("left out"), std::string::npos) << one.output;
    EXPECT_NE(trace({"--pieces", "largest"}).output.find(": 1 branch, 4"), std::string::npos);
    EXPECT_EQ(trace({"--pieces", "seeded", ready}).output, one.output);
    EXPECT_EQ(trace({"--pieces", "seeded"}).exitCode, 2);
    EXPECT_EQ(trace({"--pieces", "all", ready}).exitCode, 2);
    EXPECT_EQ(trace({"--loops", "kept"}).exitCode, 0);
}

/// Traces one arm of the bifurcating vessel, then joins the other to it; rejects a point in the air beside the patient.
TEST(Cli, TracesSingleVesselsBetweenPlacesIntoATree)
{
    const TemporaryFolder folder;
    const std::string scan = folder.file("scan.nrrd");
    ASSERT_TRUE(io::writeVolume(test::forkScan(), scan));
    const auto first =
        runCli({"trace-vessel", scan, "--between", "0,0,4,-18,0,76", "--output", folder.file("one.vtp")});
    ASSERT_EQ(first.exitCode, 0) << first.messages;
    EXPECT_NE(first.output.find("1 branch"), std::string::npos) << first.output;
    const auto second = runCli({"trace-vessel", scan, "--between", "0,0,20,18,4.5,76", "--into", folder.file("one.vtp"),
                                "--output", folder.file("two.vtp")});
    ASSERT_EQ(second.exitCode, 0) << second.messages;
    const auto tree = io::readVesselTree(folder.file("two.vtp"));
    ASSERT_TRUE(tree) << tree.error().message;
    ASSERT_EQ(tree.value().branches.size(), 2U);
    EXPECT_EQ(test::endsOf(tree.value()), 3);
    for (const core::VesselBranch& branch : tree.value().branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            EXPECT_LT(test::distanceToFork(point), 2.0);
        }
    }
    const auto outside = runCli({"trace-vessel", scan, "--between", "0,0,4,900,0,0", "--output", folder.file("x.vtp")});
    EXPECT_EQ(outside.exitCode, 3);
    EXPECT_NE(outside.messages.find("outside the scan"), std::string::npos) << outside.messages;
    EXPECT_EQ(runCli({"trace-vessel", scan, "--between", "1,2,3", "--output", folder.file("x.vtp")}).exitCode, 2);
}

TEST(Cli, TracesThinVesselsFromSeeds)
{
    const TemporaryFolder folder;
    const std::string scan = folder.file("scan.nrrd");
    ASSERT_TRUE(io::writeVolume(test::forkScan(), scan));
    const auto traced =
        runCli({"trace-vessel", scan, "--tubes", "--seed", "0,0,20", "--output", folder.file("tree.vtp")});
    ASSERT_EQ(traced.exitCode, 0) << traced.messages;
    const auto tree = io::readVesselTree(folder.file("tree.vtp"));
    ASSERT_TRUE(tree) << tree.error().message;
    EXPECT_GE(tree.value().branches.size(), 2U);
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), folder.file("mask.seg.nrrd")));
    const auto ofMask = runCli({"trace-vessel", folder.file("mask.seg.nrrd"), "--labels", "2", "--tubes", "--seed",
                                "0,0,20", "--output", folder.file("x.vtp")});
    EXPECT_EQ(ofMask.exitCode, 3);
    EXPECT_NE(ofMask.messages.find("Omit --tubes"), std::string::npos) << ofMask.messages;
    const auto unseeded = runCli({"trace-vessel", scan, "--tubes", "--output", folder.file("x.vtp")});
    EXPECT_EQ(unseeded.exitCode, 3);
    EXPECT_NE(unseeded.messages.find("none has been placed"), std::string::npos) << unseeded.messages;
}

/// Output of libraries must not appear among the program's messages.
void expectOnlyOwnMessages(const std::string& messages, const std::string& path)
{
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_TRUE(line.starts_with("angiopose-cli: ")) << path << ": " << line;
    }
}

TEST(Cli, ErrorsAreDataUnderJson)
{
    const auto outcome = runCli({"info", "/nowhere/scan.nii", "--json"});

    EXPECT_EQ(outcome.exitCode, 3);
    const auto error = nlohmann::json::parse(outcome.output)["error"];
    EXPECT_EQ(error["id"], "file.missing");
    EXPECT_EQ(error["severity"], "error");
    EXPECT_EQ(error["subject"], "/nowhere/scan.nii");
    EXPECT_NE(outcome.messages.find(error["text"].get<std::string>()), std::string::npos) << outcome.messages;
}

TEST(Cli, WarningsOfLibrariesAreNotPrinted)
{
    ANGIOPOSE_NEEDS_DATA("cerebral-dsa-frame");
    const auto path = test::dataFile("cerebral-dsa-frame/Real-DSA-01-Segmentation.png").string();
    const auto outcome = runCli({"info", path});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.messages, "") << "libpng has its doubts about a chunk that is not the picture";
}

core::Mask2d cross()
{
    core::Mask2d mask(200, 200);
    for (int i = 20; i < 180; ++i) {
        for (int across = 98; across < 103; ++across) {
            mask.at(i, across) = mask.at(across, i) = 255;
        }
    }
    return mask;
}

TEST(Cli, TracesADrawnMaskAsItIsDrawn)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(io::writePng(cross(), folder.file("mask.png")));
    const auto outcome = runCli({"trace-angiogram", folder.file("mask.png"), "--output", folder.file("curves.csv"),
                                 "--mask", folder.file("copy.png")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    EXPECT_NE(outcome.messages.find("binary mask"), std::string::npos) << outcome.messages;
    EXPECT_NE(outcome.output.find("frame 1 of 1: "), std::string::npos) << outcome.output;
    const auto curves = io::readCenterline2d(folder.file("curves.csv"));
    ASSERT_TRUE(curves) << curves.error().message;
    for (const core::Curve2d& curve : curves.value().curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            EXPECT_LT((point.array() - 100.0).abs().minCoeff(), 2.0) << "in the middle of an arm";
        }
    }
    EXPECT_EQ(test::readText(folder.file("copy.png")), test::readText(folder.file("mask.png")));
}

TEST(Cli, SaysWhatAFileIsInsteadOfWhatIsWanted)
{
    const TemporaryFolder folder;
    writeText(folder.file("notes.txt"), "Nothing of the kind.\n");
    const auto info = runCli({"info", folder.file("notes.txt")});
    EXPECT_EQ(info.exitCode, 3);
    EXPECT_NE(info.messages.find("unsupported file type. AngioPose reads cases (.angiopose)"), std::string::npos)
        << info.messages;
    const auto traced = runCli({"trace-vessel", folder.file("notes.txt"), "--output", folder.file("x.vtp")});
    EXPECT_EQ(traced.exitCode, 3);
    EXPECT_NE(traced.messages.find("unsupported volume format. Choose a DICOM folder"), std::string::npos)
        << traced.messages;
    writeText(folder.file("tree.csv"), "x,y,z\n0,0,0\n9,0,0\n");
    const auto curves = runCli({"trace-vessel", folder.file("tree.csv"), "--output", folder.file("x.vtp")});
    EXPECT_EQ(curves.exitCode, 3);
    EXPECT_NE(curves.messages.find("already contains centerlines"), std::string::npos) << curves.messages;
}

TEST(Cli, InfoOfATransformThatIsNoneSaysSo)
{
    const test::TemporaryFolder folder;
    const auto info = runCli({"info", folder.write("pose.tfm", "#Insight Transform File V1.0\nnonsense\n")});
    EXPECT_EQ(info.exitCode, 3);
    EXPECT_NE(info.messages.find("pose.tfm"), std::string::npos);
    EXPECT_EQ(info.messages.find("centerline"), std::string::npos) << info.messages;
}

TEST(Cli, DoubtsThatABallIsAVessel)
{
    const TemporaryFolder folder;
    core::VolumeGeometry geometry;
    geometry.size = {40, 40, 40};
    core::LabelVolume ball(geometry);
    test::forEachVoxel({40, 40, 40}, [&](int i, int j, int k) {
        ball.at(i, j, k) = Eigen::Vector3d(i - 19.5, j - 19.5, k - 19.5).norm() < 15.0 ? 1 : 0;
    });
    ASSERT_TRUE(io::writeLabels(ball, folder.file("ball.nrrd")));
    const auto outcome = runCli({"trace-vessel", folder.file("ball.nrrd"), "--output", folder.file("tree.csv")});
    EXPECT_TRUE(outcome.exitCode == 3 || outcome.messages.find("hardly longer than it is wide") != std::string::npos)
        << outcome.messages;
    std::fill(ball.voxels.begin(), ball.voxels.end(), std::uint16_t{0});
    ASSERT_TRUE(io::writeLabels(ball, folder.file("empty.nrrd")));
    const auto empty = runCli({"trace-vessel", folder.file("empty.nrrd"), "--output", folder.file("tree.csv")});
    EXPECT_EQ(empty.exitCode, 3);
    EXPECT_NE(empty.messages.find("contains no labeled voxels"), std::string::npos) << empty.messages;
}

/// Every odd, malformed or truncated file is either loaded or rejected with one clear message, quickly and in little
/// memory.
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
            expectOnlyOwnMessages(outcome.messages, path);
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
    EXPECT_NE(readable.output.find("from the detector"), std::string::npos);
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

}   // namespace
