#include "io/pose_convention_file.h"

#include "io/messages/messages.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

const core::PosedCamera ours{{-2281.5, 2279.5, 250.5, 261.25, 512, 480},
                             {core::expSo3({0.3, -1.1, 0.6}), {3.0, -4.0, 742.5}}};

TEST(DiffDrrFile, RestoresTheSight)
{
    const test::TemporaryFolder folder;
    ASSERT_TRUE(io::writeDiffDrr(core::diffDrrView(ours, 1020.0, {10, -150, 900}), folder.file("view.json")));
    const auto parts = io::readDiffDrr(folder.file("view.json"));
    ASSERT_TRUE(parts) << parts.error().message.text();
    const auto back = io::posedCameraFrom(parts.value());
    ASSERT_TRUE(back);
    EXPECT_LT((back.value().cameraFromPatient.matrix() - ours.cameraFromPatient.matrix()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(back.value().camera.fx, ours.camera.fx, 1e-9);
    EXPECT_EQ(back.value().camera.height, 480);
}

/// Files of xvr: detector parameters in `drr`, poses as a batch of one, and angles with a translation as an
/// alternative.
TEST(DiffDrrFile, TakesMatrixAnglesAndTable)
{
    const test::TemporaryFolder folder;
    const std::string drr =
        R"("drr": {"orientation": "PA", "sdd": 1020.0, "height": 480, "width": 512, "delx": 0.4, "dely": 0.4, "x0": 1.5, "y0": 0,
                   "reverse_x_axis": true, "renderer": "trilinear"})";
    const core::RigidTransform pose = core::diffDrrPose("ZXY", {0.1, -0.2, 0.3}, {5, -740, 8});
    const std::string matrix = [&] {
        std::string text = "[[";
        for (int i = 0; i < 4; ++i) {
            text += i ? ",[" : "[";
            for (int k = 0; k < 4; ++k) {
                text += (k ? "," : "") + std::to_string(pose.matrix()(i, k));
            }
            text += "]";
        }
        return text + "]]";
    }();
    const auto poseIn = [](const core::Result<io::DiffDrrParts>& parts) {
        return parts && parts.value().pose ? parts.value().pose->matrix() : Eigen::Matrix4d::Zero().eval();
    };
    const auto ofMatrix = io::readDiffDrr(folder.write("m.json", "{" + drr + R"(, "final_pose": )" + matrix + "}"));
    ASSERT_TRUE(ofMatrix) << ofMatrix.error().message.text();
    EXPECT_LT((poseIn(ofMatrix) - pose.matrix()).cwiseAbs().maxCoeff(), 1e-5);
    ASSERT_TRUE(ofMatrix.value().detector);
    EXPECT_EQ(ofMatrix.value().detector->orientation, core::DiffDrrOrientation::Pa);

    const auto ofAngles = io::readDiffDrr(folder.write(
        "a.json", "{" + drr + R"(, "rotation": [[0.1, -0.2, 0.3]], "translation": [[5, -740, 8]], "parameterization":
        "euler_angles", "convention": "ZXY"})"));
    ASSERT_TRUE(ofAngles) << ofAngles.error().message.text();
    EXPECT_LT((poseIn(ofAngles) - pose.matrix()).cwiseAbs().maxCoeff(), 1e-12);

    const auto ofTable = io::readDiffDrr(
        folder.write("t.csv", "r1,r2,r3,tx,ty,tz,ncc\n0,0,0,0,-700,0,0.5\n0.1,-0.2,0.3,5,-740,8,0.9\n"));
    EXPECT_LT((poseIn(ofTable) - pose.matrix()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_FALSE(ofTable.value().detector);
    EXPECT_TRUE(io::posedCameraFrom(ofTable.value()).error().message.is(io::messages::diffDrrKeys));
}

TEST(DiffDrrFile, NamesTheKeyThatIsWrong)
{
    const test::TemporaryFolder folder;
    const auto reported = [&](const std::string& json) {
        const auto parts = io::readDiffDrr(folder.write("v.json", json));
        return parts ? std::string("read") : parts.error().message.text();
    };
    EXPECT_NE(reported(R"({"sdd": 1020, "delx": 0.4})").find("height"), std::string::npos);
    EXPECT_NE(reported(R"({"sdd": -1, "height": 4, "delx": 0.4})").find("sdd"), std::string::npos);
    EXPECT_NE(reported(R"({"sdd": 1020, "height": 4, "delx": 0.4, "orientation": "LAO"})").find("orientation"),
              std::string::npos);
    EXPECT_NE(reported(R"({"sdd": 1020, "height": 4, "delx": 0.4, "pose": [[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]]})")
                  .find("pose"),
              std::string::npos);
    EXPECT_TRUE(io::readDiffDrr(folder.write("parameters.pt", "PK")).error().message.is(io::messages::exchangePickle));
}

}   // namespace
