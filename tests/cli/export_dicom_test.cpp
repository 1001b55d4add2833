#include "io/case/case_file.h"
#include "io/dicom/dicom_file.h"
#include "io/file_hash.h"
#include "io/pose_file.h"
#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::runCli;

class CliExportDicom : public ::testing::Test {
protected:
    void SetUp() override
    {
        const auto simulated = runCli({"simulate", "--seed", "3", "--output", folder_.file("demo")});
        ASSERT_EQ(simulated.exitCode, 0) << simulated.messages;
        casePath_ = folder_.file("demo/case.angiopose");
    }

    test::ProgramOutcome exported(std::vector<std::string> more)
    {
        std::vector<std::string> arguments{"export-dicom",      casePath_, "--output",
                                           folder_.file("out"), "--width", "160"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments);
    }
    std::string text(const std::string& path, io::DicomTag tag) const
    {
        const std::string content = test::readText(path);
        const auto file = io::parseDicom(content, path);
        EXPECT_TRUE(file) << path;
        return file ? std::string(file.value().dataset.text(tag)) : std::string();
    }
    std::string out(const std::string& name) const { return folder_.file("out/" + name); }

    test::TemporaryFolder folder_;
    std::string casePath_;
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
    EXPECT_NE(outcome.messages.find("report.dcm: the report is made by the window"), std::string::npos)
        << outcome.messages;
    EXPECT_NE(outcome.messages.find("cannot hold the perspective camera"), std::string::npos) << outcome.messages;
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
    const auto theCase = io::loadCase(casePath_, warnings);
    ASSERT_TRUE(theCase);
    const Eigen::Matrix4d pose = theCase.value().shown().cameraFromPatient.matrix();
    const auto asObject = io::readPose(out("registration.dcm"));
    const auto asJson = io::readPose(out("camera.json"));
    ASSERT_TRUE(asObject && asJson);
    EXPECT_LE((asObject.value().matrix() - pose).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ(asJson.value().matrix(), pose);
    const auto camera = nlohmann::json::parse(test::readText(out("camera.json")))["camera"];
    EXPECT_EQ(camera["fx"].get<double>(), core::cameraOf(theCase.value().shown()).value().fx);
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
    EXPECT_NE(outcome.messages.find("needs the scan or the mask"), std::string::npos) << outcome.messages;
    EXPECT_FALSE(fs::exists(folder_.file("out")));
    const auto unknown = exported({"--objects", "sc,hologram"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.messages.find("sc, run, pdf, ps, reg, seg, sr"), std::string::npos) << unknown.messages;
}

/// Its archive keeps both.
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
