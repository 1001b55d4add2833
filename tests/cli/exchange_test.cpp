#include "io/fiducial_file.h"
#include "io/opening/read_case_inputs.h"
#include "io/pose_camera_file.h"
#include "io/pose_convention_file.h"
#include "io/pose_file.h"
#include "tests/cli/simulated_case.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

using test::runCli;

class ExchangeOnSimulatedCase : public test::SimulatedCaseTest {
protected:
    void SetUp() override
    {
        SimulatedCaseTest::SetUp();
        core::Messages warnings;
        const auto opened = io::openCase(casePath_, warnings);
        ASSERT_TRUE(opened);
        view_ = opened.value().shown();
        camera_ = core::cameraOf(view_).value();
    }

    void convert(const std::string& in, const std::string& out, const std::vector<std::string>& options = {})
    {
        std::vector<std::string> arguments{"convert", in, folder_.file(out)};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto outcome = runCli(arguments);
        ASSERT_EQ(outcome.exitCode, 0) << out << ": " << outcome.messages;
    }

    /// Largest distance between the projections of points around the vessels by the case and by this pose with its
    /// camera, px.
    double apartPx(const io::PoseWithCamera& pose) const
    {
        double apart = 0.0;
        const Eigen::Vector3d middle = view_.cameraFromPatient.inverse() * Eigen::Vector3d(0, 0, 750);
        for (const Eigen::Vector3d& step :
             {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(40, 5, -30), Eigen::Vector3d(-20, 60, 10)}) {
            const auto ours = core::project(camera_, view_.cameraFromPatient * (middle + step).eval());
            const auto theirs = core::project(*pose.camera, pose.cameraFromPatient * (middle + step).eval());
            apart = std::max(apart, (*ours - *theirs).norm());
        }
        return apart;
    }

    core::View view_;
    core::ProjectionCamera camera_;
};

TEST_F(ExchangeOnSimulatedCase, GivesItsCameraAndPoseInEveryForm)
{
    for (const char* name : {"pose.txt", "pose.yml", "pose.xml", "pose.json"}) {
        convert(casePath_, name);
        const auto read = io::readPoseWithCamera(folder_.file(name));
        ASSERT_TRUE(read) << read.error().message.text();
        ASSERT_TRUE(read.value().camera) << name;
        EXPECT_LT(apartPx(read.value()), 1e-9) << name;
    }
    convert(casePath_, "opencv.json", {"--pose-to", "opencv"});
    EXPECT_TRUE(nlohmann::json::parse(test::readText(folder_.file("opencv.json"))).contains("K"));
    const auto info = runCli({"info", folder_.file("pose.yml"), "--json"});
    ASSERT_EQ(info.exitCode, 0) << info.messages;
    EXPECT_EQ(nlohmann::json::parse(info.output)["camera"]["shownFrom"], "detector");
    EXPECT_EQ(runCli({"convert", folder_.file("demo/true-pose.json"), folder_.file("none.yml")}).exitCode,
              3);   // no camera
    convert(folder_.file("demo/true-pose.json"), "with.yml", {"--camera", casePath_});
}

TEST_F(ExchangeOnSimulatedCase, ComesBackFromXregAndDiffDrr)
{
    convert(casePath_, "xreg.h5", {"--pose-to", "xreg"});
    const auto theirs = io::readPose(folder_.file("xreg.h5"));
    ASSERT_TRUE(theirs);
    EXPECT_LT((theirs.value() * Eigen::Vector3d::Zero().eval() -
               view_.cameraFromPatient.inverse() * Eigen::Vector3d::Zero().eval())
                  .norm(),
              1e-9);   // the origin of their world is the source
    convert(folder_.file("xreg.h5"), "back.yml", {"--pose-from", "xreg", "--camera", casePath_});
    EXPECT_LT(apartPx(io::readPoseWithCamera(folder_.file("back.yml")).value()), 1e-9);

    convert(casePath_, "view.json", {"--pose-to", "diffdrr", "--source-to-detector", "1020"});
    const auto parts = io::readDiffDrr(folder_.file("view.json"));
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts.value().detector->sddMm, 1020.0);
    EXPECT_EQ(parts.value().detector->orientation, core::DiffDrrOrientation::Pa);
    convert(folder_.file("view.json"), "again.txt", {"--pose-from", "diffdrr"});
    EXPECT_LT(apartPx(io::readPoseWithCamera(folder_.file("again.txt")).value()), 1e-8);
}

TEST_F(ExchangeOnSimulatedCase, ProjectsByTheCameraThatThePoseBrings)
{
    convert(casePath_, "own.yml");
    const auto same =
        runCli({"project", casePath_, "--pose", folder_.file("own.yml"), "--output", folder_.file("a.png")});
    EXPECT_EQ(same.exitCode, 0);
    EXPECT_EQ(same.messages.find("camera"), std::string::npos) << same.messages;
    core::ProjectionCamera other = camera_;
    other.fx *= 1.1;
    ASSERT_TRUE(io::writePosedCamera({other, view_.cameraFromPatient}, folder_.file("other.yml")));
    const auto reported =
        runCli({"project", casePath_, "--pose", folder_.file("other.yml"), "--output", folder_.file("b.png")});
    EXPECT_EQ(reported.exitCode, 0);
    EXPECT_NE(reported.messages.find("with a different camera from that of the case"), std::string::npos)
        << reported.messages;
    EXPECT_NE(test::readText(folder_.file("a.png")), test::readText(folder_.file("b.png")));
    other.width *= 2;
    ASSERT_TRUE(io::writePosedCamera({other, view_.cameraFromPatient}, folder_.file("size.yml")));
    EXPECT_EQ(
        runCli({"project", casePath_, "--pose", folder_.file("size.yml"), "--output", folder_.file("c.png")}).exitCode,
        3);
}

TEST_F(ExchangeOnSimulatedCase, GivesItsPointsToSlicer)
{
    const auto none = runCli({"convert", casePath_, folder_.file("none.fcsv")});
    EXPECT_EQ(none.exitCode, 3);
    EXPECT_NE(none.messages.find("target points"), std::string::npos);
    auto json = nlohmann::ordered_json::parse(test::readText(casePath_));
    json["vessel"]["marks"] = {
        {{"id", 1}, {"kind", "check-point"}, {"name", "fork, first"}, {"pointInPatientMm", {1.5, -2, 30}}}};
    json["pose"]["landmarks"] = {{{"name", "tip"}, {"pointInPatientMm", {4, 5, 6}}, {"pixel", {10, 20}}}};
    const std::string marked = folder_.write("demo/marked.angiopose", json.dump());
    convert(marked, "points.fcsv");
    convert(folder_.file("points.fcsv"), "points.mrk.json");
    const auto points = io::readFiducials(folder_.file("points.mrk.json"));
    ASSERT_TRUE(points);
    ASSERT_EQ(points.value().size(), 2u);
    EXPECT_EQ(points.value()[0], (io::Fiducial{{1.5, -2, 30}, "fork, first", "target point"}));
    EXPECT_EQ(points.value()[1], (io::Fiducial{{4, 5, 6}, "tip", "landmark"}));
    const auto info = runCli({"info", folder_.file("points.fcsv"), "--json"});
    EXPECT_EQ(nlohmann::json::parse(info.output)["points"].size(), 2u);
}

}   // namespace
