#include "core/messages/messages.h"
#include "io/centerline2d_file.h"
#include "io/decode/ask_decoder.h"
#include "io/file_hash.h"
#include "io/image_file.h"
#include "io/messages/messages.h"
#include "io/pose_file.h"
#include "io/results/result_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

core::RigidTransform oddPose()
{
    return {core::expSo3({0.3, -1.1, 2.0 / 3.0}), Eigen::Vector3d(1.0 / 3.0, -1e-9, 742.123456789012345)};
}

std::string poseErrorOf(const core::Result<core::RigidTransform>& pose)
{
    return pose ? "loaded" : pose.error().message.text();
}

}   // namespace

TEST(Sha256OfFile, MatchesTheStandardsExample)
{
    const test::TemporaryFolder folder;
    EXPECT_EQ(io::sha256OfFile(folder.write("abc", "abc")).value(),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");   // FIPS 180-2, B.1
    EXPECT_FALSE(io::sha256OfFile(folder.file("absent")));
}

TEST(WritePose, RestoresEveryBit)
{
    const test::TemporaryFolder folder;
    for (const char* name : {"pose.json", "pose.tfm", "pose.h5"}) {
        ASSERT_TRUE(io::writePose(oddPose(), folder.file(name)));
        const auto pose = io::readPose(folder.file(name));
        ASSERT_TRUE(pose) << pose.error().message;
        EXPECT_EQ(pose.value().matrix(), oddPose().matrix());
    }
    EXPECT_FALSE(io::writePose(oddPose(), folder.file("pose.xml")));
}

TEST(ReadPose, KnowsItksRigidTransforms)
{
    const test::TemporaryFolder folder;
    // 90 degrees about z through the center (1, 0, 0).
    const std::string text =
        "#Insight Transform File V1.0\n#Transform 0\nTransform: Euler3DTransform_double_3_3\n"
        "Parameters: 0 0 1.5707963267948966 0 0 5\nFixedParameters: 1 0 0\n";
    const auto pose = io::readPose(folder.write("euler.tfm", text));
    ASSERT_TRUE(pose) << pose.error().message;
    EXPECT_NEAR((pose.value() * Eigen::Vector3d(2, 0, 0) - Eigen::Vector3d(1, 1, 5)).norm(), 0.0, 1e-12);
    const std::string scaled =
        "#Insight Transform File V1.0\nTransform: AffineTransform_double_3_3\n"
        "Parameters: 2 0 0 0 2 0 0 0 2 0 0 0\nFixedParameters: 0 0 0\n";
    EXPECT_NE(poseErrorOf(io::readPose(folder.write("scaled.tfm", scaled))).find("not a rotation"), std::string::npos);
    EXPECT_NE(
        poseErrorOf(io::readPose(folder.write("spline.tfm", "#Insight Transform File V1.0\nTransform: BSpline\n")))
            .find("not rigid"),
        std::string::npos);
}

TEST(ReadPose, FollowsTheOrderOfEulerAngles)
{
    const test::TemporaryFolder folder;
    const std::string start =
        "#Insight Transform File V1.0\n#Transform 0\nTransform: Euler3DTransform_double_3_3\n"
        "Parameters: 0.3 0.2 0 0 0 0\nFixedParameters: 0 0 0 ";
    const Eigen::AngleAxisd x(0.3, Eigen::Vector3d::UnitX()), y(0.2, Eigen::Vector3d::UnitY());
    for (const bool isZyx : {false, true}) {
        const auto pose = io::readPose(folder.write("order.tfm", start + (isZyx ? "1\n" : "0\n")));
        ASSERT_TRUE(pose) << pose.error().message;
        EXPECT_TRUE(pose.value().rotation.isApprox((isZyx ? y * x : x * y).toRotationMatrix(), 1e-12));
    }
}

TEST(ReadPose, TakesTheMatlabFilesOfItk)
{
    // As written by ITK 5.2: Euler angles 0.1, -0.2, 0.3, translation 1.5, -2, 740.25, center 10, 20, 30.
    const auto matrix = [](const std::string& name, const std::vector<double>& values) {
        const std::array<std::uint32_t, 5> head{0, static_cast<std::uint32_t>(values.size()), 1, 0,
                                                static_cast<std::uint32_t>(name.size() + 1)};
        return std::string(reinterpret_cast<const char*>(head.data()), sizeof head) + name + '\0' +
               std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
    };
    const std::string content =
        matrix("Euler3DTransform_double_3_3", {0.1, -0.2, 0.3, 1.5, -2, 740.25}) + matrix("fixed", {10, 20, 30, 0});
    const test::TemporaryFolder folder;
    const auto pose = io::readPose(folder.write("euler.mat", content));
    ASSERT_TRUE(pose) << pose.error().message;
    Eigen::Matrix3d rotation;   // the matrix that ITK computes for these angles
    rotation << 0.9421546635113683, -0.29404383655185584, -0.16088136066569614, 0.2706814883919034, 0.9505637859220634,
        -0.15218416716418803, 0.19767681165408388, 0.09983341664682815, 0.975170327201816;
    EXPECT_TRUE(pose.value().rotation.isApprox(rotation, 1e-14));
    const Eigen::Vector3d center(10, 20, 30);
    EXPECT_TRUE((pose.value() * center).isApprox(center + Eigen::Vector3d(1.5, -2, 740.25), 1e-14));
    for (std::size_t size = 0; size < content.size(); ++size) {
        EXPECT_FALSE(io::readPose(folder.write("cut.mat", content.substr(0, std::max<std::size_t>(size, 1)))));
    }
}

TEST(ReadPose, Hdf5FilesMustBeRigid)
{
    const test::TemporaryFolder folder;
    const auto written = [&folder](const std::string& scale) {
        const auto reply = io::runDecoder(
            "angiopose-decode-itk", {"write", scale, "0", "0", "1.5", "0", scale, "0", "-2", "0", "0", scale, "740.25"},
            folder.file("pose.h5"));
        EXPECT_TRUE(reply) << reply.error().message;
        return folder.write("pose.h5", reply ? reply.value().content : "");
    };
    const auto pose = io::readPose(written("1"));
    ASSERT_TRUE(pose) << pose.error().message;
    EXPECT_EQ(pose.value().translation, Eigen::Vector3d(1.5, -2.0, 740.25));
    EXPECT_NE(poseErrorOf(io::readPose(written("2"))).find("not a rotation"), std::string::npos);
    EXPECT_NE(poseErrorOf(io::readPose(written("-1"))).find("reflection"), std::string::npos);
    const std::string other = folder.write("other.h5", "\x89HDF\r\n\x1a\n and nothing of a transform");
    EXPECT_TRUE(io::readPose(other).error().message.is(io::messages::poseNoTransform));
}

TEST(ReadPose, CutHdf5FilesAreRefused)
{
    const test::TemporaryFolder folder;
    ASSERT_TRUE(io::writePose(oddPose(), folder.file("pose.h5")));
    const std::string content = test::readText(folder.file("pose.h5"));
    ASSERT_GT(content.size(), 1000U);
    for (std::size_t size = 8; size < content.size(); size += content.size() / 40) {
        const auto pose = io::readPose(folder.write("cut.h5", content.substr(0, size)));
        ASSERT_FALSE(pose) << size;
        EXPECT_TRUE(pose.error().message.text().starts_with(folder.file("cut.h5"))) << pose.error().message;
    }
}

TEST(ReadPose, FindsThePoseInAResult)
{
    const test::TemporaryFolder folder;
    core::Case session;
    session.shown().result.emplace().cameraFromPatient = oddPose();
    ASSERT_TRUE(io::writeResult(session, folder.file("result.json")));
    const auto pose = io::readPose(folder.file("result.json"));
    ASSERT_TRUE(pose) << pose.error().message;
    EXPECT_EQ(pose.value().matrix(), oddPose().matrix());
}

TEST(ResultJson, HasEveryPromisedKey)
{
    core::Case session;
    session.vessels.file = {"/data/tree.vtp", std::string(64, 'a')};
    core::RegistrationResult result;
    result.method = "dynaweight";
    result.metrics.medianPx = 0.75;
    result.uncertainty.covariance(2, 5) = 0.125;
    result.branches.push_back({4, 20, 0.5, 1.5, 0.9});
    result.unopacified.push_back({7, 0.75});
    result.stopReason = core::StopReason::StoppedByUser;
    result.warnings = {core::messages::depthUndetermined()};
    const nlohmann::json json = nlohmann::json::parse(io::resultJson(session, result));
    EXPECT_EQ(json["format"], "angiopose-result");
    EXPECT_EQ(json["version"], 2);
    EXPECT_EQ(json["method"], "dynaweight");
    EXPECT_EQ(json["pose"]["cameraFromPatient"][3][3], 1.0);
    EXPECT_EQ(json["metrics"]["medianProjectionDistancePx"], 0.75);
    EXPECT_TRUE(json["metrics"].contains("reverseDistanceMm"));
    EXPECT_EQ(json["uncertainty"]["covariance"][2][5], 0.125);
    EXPECT_EQ(json["perBranch"][0]["branch"], 4);
    EXPECT_EQ(json["unfilled"][0]["branch"], 7);
    EXPECT_EQ(json["unfilled"][0]["share"], 0.75);
    EXPECT_EQ(json["trustworthy"], false);
    EXPECT_EQ(json["warnings"][0], core::messages::depthUndetermined().text());
    EXPECT_EQ(json["messages"][0]["id"], "trust.depth-unknown");
    EXPECT_EQ(json["stopReason"], core::toText(core::StopReason::StoppedByUser));
    EXPECT_TRUE(json["timeMs"].contains("total"));
    EXPECT_EQ(json["inputs"]["vessel"]["sha256"], std::string(64, 'a'));
    EXPECT_EQ(json["inputs"]["vessel"]["file"], "tree.vtp");
    EXPECT_TRUE(json["options"].is_object());
    EXPECT_FALSE(json["programVersion"].get<std::string>().empty());
}

TEST(WriteCenterline2d, RestoresEveryBit)
{
    const test::TemporaryFolder folder;
    const core::Centerline2d original{
        {{5, {{1.0 / 3.0, 2.0}, {3.5, -0.25}}, {0.1, 0.7}}, {9, {{7, 8}, {9, 10}}, {1, 2}}}};
    ASSERT_TRUE(io::writeCenterline2d(original, folder.file("curve.csv")));
    const auto read = io::readCenterline2d(folder.file("curve.csv"));
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read.value().curves.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(read.value().curves[i].id, original.curves[i].id);
        EXPECT_EQ(read.value().curves[i].pointsPx, original.curves[i].pointsPx);
        EXPECT_EQ(read.value().curves[i].radiusPx, original.curves[i].radiusPx);
    }
}

TEST(ReadCenterline2d, TakesColumnsInAnyOrder)
{
    const test::TemporaryFolder folder;
    const auto read = io::readCenterline2d(folder.write("c.csv", "note, Y ,X\r\na,1,2\r\nb,3,4\r\n"));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read.value().curves[0].pointsPx[1], Eigen::Vector2d(4, 3));
    EXPECT_FALSE(io::readCenterline2d(folder.write("d.csv", "x,y,z\n1,2,3\n4,5,6\n")));
    EXPECT_FALSE(io::readCenterline2d(folder.write("e.csv", "x,y\n1,inf\n4,5\n")));
}

TEST(ReadCenterline2d, TracesADrawnMask)
{
    const test::TemporaryFolder folder;
    core::Mask2d mask(120, 60);
    for (int x = 10; x < 110; ++x) {
        for (int y = 28; y <= 32; ++y) {
            mask.at(x, y) = 1;
        }
    }
    ASSERT_TRUE(io::writePng(mask, folder.file("mask.png")));
    const auto read = io::readCenterline2d(folder.file("mask.png"));
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read.value().curves.size(), 1u);
    for (const Eigen::Vector2d& point : read.value().curves[0].pointsPx) {
        EXPECT_NEAR(point.y(), 30.0, 1.0);
    }
    EXPECT_GT(read.value().curves[0].lengthPx(), 85.0);
}
