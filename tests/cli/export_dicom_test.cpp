#include "io/case/case_file.h"
#include "io/dicom/dicom_file.h"
#include "io/file_hash.h"
#include "io/pose_file.h"
#include "io/volume_file.h"
#include "tests/cli/simulated_case.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::runCli;

class CliExportDicom : public test::SimulatedCaseTest {
protected:
    test::ProgramOutcome exported(std::vector<std::string> more)
    {
        std::vector<std::string> arguments{"export-dicom", casePath_, "--output",    folder_.file("out"),
                                           "--width",      "160",     "--start-pose"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments);
    }
    template <class Change>
    void change(const Change& change) const
    {
        auto json = nlohmann::ordered_json::parse(test::readText(casePath_));
        change(json);
        test::writeText(casePath_, json.dump());
    }
    io::DicomDataset dataset(const std::string& name)
    {
        content_ = test::readText(out(name));
        const auto file = io::parseDicom(content_, name);
        EXPECT_TRUE(file) << name;
        return file ? file.value().dataset : io::DicomDataset();
    }
    std::string text(const std::string& path, io::DicomTag tag) const
    {
        const std::string content = test::readText(path);
        const auto file = io::parseDicom(content, path);
        EXPECT_TRUE(file) << path;
        return file ? std::string(file.value().dataset.text(tag)) : std::string();
    }
    std::string out(const std::string& name) const { return folder_.file("out/" + name); }

    std::string content_;
};

TEST_F(CliExportDicom, WritesWhatTheCaseAllowsAndSaysWhatNot)
{
    const std::string before = io::sha256OfFile(folder_.file("demo/angiogram.dcm")).value();
    const auto outcome = exported({"--register"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    for (const char* name : {"overlay.dcm", "overlay-run.dcm", "presentation-state.dcm", "registration.dcm",
                             "measurements.dcm", "camera.json"}) {
        EXPECT_TRUE(fs::exists(out(name))) << name;
        EXPECT_NE(outcome.output.find(name), std::string::npos);
    }
    EXPECT_FALSE(fs::exists(out("report.dcm")));
    EXPECT_NE(outcome.messages.find("report.dcm: reports are created with `angiopose-cli report`"), std::string::npos)
        << outcome.messages;
    EXPECT_NE(outcome.messages.find("cannot store the perspective camera"), std::string::npos) << outcome.messages;
    EXPECT_EQ(io::sha256OfFile(folder_.file("demo/angiogram.dcm")).value(), before) << "the original is untouched";
    const std::string study = text(folder_.file("demo/angiogram.dcm"), 0x0020000d);
    for (const char* name : {"overlay.dcm", "presentation-state.dcm", "registration.dcm", "measurements.dcm"}) {
        EXPECT_EQ(text(out(name), 0x0020000d), study) << name;
    }
}

TEST_F(CliExportDicom, RegistrationAndCameraHoldThePoseOfTheCase)
{
    ASSERT_EQ(exported({"--objects", "reg"}).exitCode, 0);
    core::Messages warnings;
    const auto session = io::loadCase(casePath_, warnings);
    ASSERT_TRUE(session);
    const Eigen::Matrix4d pose = session.value().shown().cameraFromPatient.matrix();
    const auto asObject = io::readPose(out("registration.dcm"));
    const auto asJson = io::readPose(out("camera.json"));
    ASSERT_TRUE(asObject && asJson);
    EXPECT_LE((asObject.value().matrix() - pose).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ(asJson.value().matrix(), pose);
    const auto camera = nlohmann::json::parse(test::readText(out("camera.json")))["camera"];
    EXPECT_EQ(camera["fx"].get<double>(), core::cameraOf(session.value().shown()).value().fx);
    EXPECT_EQ(
        runCli({"project", casePath_, "--pose", out("registration.dcm"), "--output", folder_.file("a.png")}).exitCode,
        0);
    EXPECT_EQ(runCli({"convert", out("registration.dcm"), folder_.file("pose.tfm")}).exitCode, 0);
}

TEST_F(CliExportDicom, NeverMakesTheSameInstanceTwice)
{
    ASSERT_EQ(exported({"--objects", "sc"}).exitCode, 0);
    const std::string first = text(out("overlay.dcm"), 0x00080018);
    ASSERT_EQ(exported({"--objects", "sc"}).exitCode, 0);
    EXPECT_NE(text(out("overlay.dcm"), 0x00080018), first);
}

TEST_F(CliExportDicom, WrapsAReport)
{
    test::writeText(folder_.file("report.pdf"), "%PDF-1.4\nno more");
    ASSERT_EQ(exported({"--objects", "pdf", "--report", folder_.file("report.pdf")}).exitCode, 0);
    EXPECT_NE(test::readText(out("report.dcm")).find("%PDF-1.4\nno more"), std::string::npos);
}

TEST_F(CliExportDicom, WritesNothingWhereOneObjectCannotBeMade)
{
    const auto outcome = exported({"--objects", "sc,seg"});
    EXPECT_EQ(outcome.exitCode, 3);
    EXPECT_NE(outcome.messages.find("requires the scan or mask"), std::string::npos) << outcome.messages;
    EXPECT_FALSE(fs::exists(folder_.file("out")));
    const auto unknown = exported({"--objects", "sc,hologram"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.messages.find("sc, run, pdf, ps, reg, seg, sr"), std::string::npos) << unknown.messages;
}

TEST_F(CliExportDicom, SaysWhetherPicturesMayNameThePatient)
{
    const auto annotated = [this](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"--objects", "sc"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(exported(arguments).exitCode, 0);
        return std::string(dataset("overlay.dcm").text(0x00280301));
    };
    EXPECT_EQ(annotated({}), "YES") << "the patient is called Simulated, and so is the case";
    change([](auto& json) { json["title"] = "Case A"; });
    EXPECT_EQ(annotated({}), "NO");
    EXPECT_EQ(annotated({"--identity"}), "YES");
}

TEST_F(CliExportDicom, RunHasEveryFrame)
{
    ASSERT_EQ(exported({"--objects", "run"}).exitCode, 0);
    const io::DicomDataset data = dataset("overlay-run.dcm");
    EXPECT_EQ(data.integer(0x00280008), 8);
    EXPECT_EQ(data.integer(0x00280011), 160);
}

/// A tree in a scan: its tubes are rasterized on the scan's own grid.
TEST_F(CliExportDicom, SegmentationIsTheTreeInTheGridOfTheScan)
{
    for (int k = 0; k < 12; ++k) {
        test::CtSlice slice;
        slice.sopInstanceUid = "1.2.3." + std::to_string(k + 1);
        slice.instanceNumber = k + 1;
        slice.columns = 16;
        slice.rows = 20;
        slice.position = {-4.0, -7.5, 50.0 + k};
        slice.pixels.assign(320, 0);
        folder_.write("demo/scan/" + std::to_string(k) + ".dcm", test::ctSlice(slice));
    }
    test::writeText(folder_.file("demo/tree.csv"), "branch,x,y,z,radius\n1,0,0,52,1.1\n1,0,0,56,1.1\n1,0,0,59,1.1\n");
    change([](auto& json) {
        json["vessel"] = {{"centerline", {{"path", "tree.csv"}}}, {"volume", {{"path", "scan"}}}};
    });
    const auto outcome = exported({"--objects", "seg"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    const auto labels = io::readLabels(out("segmentation.dcm"));
    const auto scan = io::readVolume(folder_.file("demo/scan"));
    ASSERT_TRUE(labels && scan);
    const core::VolumeGeometry& grid = labels.value().geometry;
    EXPECT_EQ(grid.size, scan.value().volume.geometry.size);
    EXPECT_LE((grid.patientFromVoxel().matrix() - scan.value().volume.geometry.patientFromVoxel().matrix())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-9);
    for (std::size_t i = 0; i < labels.value().voxels.size(); ++i) {
        const Eigen::Vector3d place = grid.patientFromVoxel() * grid.voxelAt(i).cast<double>();
        const double across = place.head<2>().norm();
        const double beyond = std::max({52.0 - place.z(), place.z() - 59.0, 0.0});
        const double distance = std::hypot(across, beyond);
        if (std::abs(distance - 1.1) > 0.1) {   // tubes are chains of balls
            EXPECT_EQ(labels.value().voxels[i] != 0, distance < 1.1) << place.transpose();
        }
    }
}

/// The window of an inverted image refers to its stored values.
TEST_F(CliExportDicom, StateOfAnInvertedImageHasTheWindowOfItsStoredValues)
{
    const auto shown = [this] {
        EXPECT_EQ(exported({"--objects", "ps"}).exitCode, 0);
        const io::DicomDataset data = dataset("presentation-state.dcm");
        const io::DicomDataset window = data.items(0x00283110).front();
        return std::array{window.number(0x00281050).value_or(0.0), window.number(0x00281051).value_or(0.0),
                          data.text(0x20500020) == "INVERSE" ? 1.0 : 0.0};
    };
    const auto plain = shown();
    const std::string path = folder_.file("demo/angiogram.dcm");
    std::string bytes = test::readText(path);
    const std::size_t at = bytes.find("MONOCHROME2");
    ASSERT_NE(at, std::string::npos);
    bytes[at + 10] = '1';
    test::writeText(path, bytes);
    const auto inverted = shown();
    EXPECT_EQ(plain[2], 0.0);
    EXPECT_EQ(inverted[2], 1.0);
    EXPECT_NEAR(inverted[0], plain[0], 0.25 * plain[1]);
    EXPECT_NEAR(inverted[1], plain[1], 0.25 * plain[1]);
}

/// An archive keeps both instances.
TEST_F(CliExportDicom, ConvertMakesAnotherInstanceOfTheSameStudy)
{
    const std::string source = folder_.file("demo/angiogram.dcm");
    ASSERT_EQ(runCli({"convert", source, folder_.file("a.dcm")}).exitCode, 0);
    ASSERT_EQ(runCli({"convert", source, folder_.file("b.dcm")}).exitCode, 0);
    EXPECT_NE(text(folder_.file("a.dcm"), 0x00080018), text(source, 0x00080018));
    EXPECT_NE(text(folder_.file("a.dcm"), 0x0020000e), text(source, 0x0020000e));
    EXPECT_EQ(text(folder_.file("a.dcm"), 0x0020000d), text(source, 0x0020000d));
    EXPECT_EQ(test::readText(folder_.file("a.dcm")), test::readText(folder_.file("b.dcm")));
    ASSERT_EQ(runCli({"convert", folder_.file("a.dcm"), folder_.file("c.dcm")}).exitCode, 0);
    EXPECT_NE(text(folder_.file("c.dcm"), 0x00080018), text(folder_.file("a.dcm"), 0x00080018));
    const std::string content = test::readText(folder_.file("a.dcm"));
    const auto copy = io::parseDicom(content, "a.dcm");
    ASSERT_TRUE(copy);
    ASSERT_FALSE(copy.value().dataset.items(0x00082112).empty());
    EXPECT_EQ(copy.value().dataset.items(0x00082112).front().text(0x00081155), text(source, 0x00080018));
    EXPECT_FALSE(copy.value().dataset.text(0x00082111).empty());
}

}   // namespace
