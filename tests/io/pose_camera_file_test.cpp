#include "io/pose_camera_file.h"

#include "core/messages/messages.h"
#include "io/camera_pose_file.h"
#include "io/messages/messages.h"
#include "io/pose_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

const core::PosedCamera oddSight{{-2281.123456789, 2279.5, 250.5, 1.0 / 3.0, 512, 480},
                                 {core::expSo3({0.3, -1.1, 2.0 / 3.0}), {1.0 / 3.0, -1e-9, 742.123456789012345}}};

/// As written by OpenCV 4.6, for the matrices of a camera with a 3:4:5 rotation.
const std::string openCvYaml = R"(%YAML:1.0
---
image_width: 512
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ -2281.25, 0., 250.5, 0., 2279.5,
       261.25, 0., 0., 1. ]
R: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 6.0000000000000009e-01, -8.0000000000000004e-01, 0.,
       8.0000000000000004e-01, 6.0000000000000009e-01, 0., 0., 0., 1. ]
t: !!opencv-matrix
   rows: 3
   cols: 1
   dt: d
   data: [ 12.5, -7.25, 741.0625 ]
distortion_coefficients: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ 0., 0., 0., 0., 0. ]
)";

const std::string openCvXml = R"(<?xml version="1.0"?>
<opencv_storage>
<image_width>512</image_width>
<image_height>480</image_height>
<camera_matrix type_id="opencv-matrix">
  <rows>3</rows>
  <cols>3</cols>
  <dt>d</dt>
  <data>
    -2281.25 0. 250.5 0. 2279.5 261.25 0. 0. 1.</data></camera_matrix>
<R type_id="opencv-matrix">
  <rows>3</rows>
  <cols>3</cols>
  <dt>d</dt>
  <data>
    6.0000000000000009e-01 -8.0000000000000004e-01 0.
    8.0000000000000004e-01 6.0000000000000009e-01 0. 0. 0. 1.</data></R>
<t type_id="opencv-matrix">
  <rows>3</rows>
  <cols>1</cols>
  <dt>d</dt>
  <data>
    12.5 -7.25 741.0625</data></t>
</opencv_storage>
)";

/// K, R and t under the names used by PyYAML and numpy, and the keys of ROS.
const std::string plainYaml = R"(image_size: [512, 480]
K:
- - -2281.25
  - 0.0
  - 250.5
- - 0.0
  - 2279.5
  - 261.25
- [0.0, 0.0, 1.0]
R: [[0.6, -0.8, 0.0],
    [0.8, 0.6, 0.0],
    [0.0, 0.0, 1.0]]
tvec: [12.5, -7.25, 741.0625]
)";

void expectTurned(const core::Result<io::PoseWithCamera>& read)
{
    ASSERT_TRUE(read) << read.error().message.text();
    const core::RigidTransform& pose = read.value().cameraFromPatient;
    EXPECT_NEAR(pose.rotation(0, 1), -0.8, 1e-15);
    EXPECT_EQ(pose.translation, Eigen::Vector3d(12.5, -7.25, 741.0625));
    ASSERT_TRUE(read.value().camera);
    EXPECT_EQ(*read.value().camera, (core::ProjectionCamera{-2281.25, 2279.5, 250.5, 261.25, 512, 480}));
}

TEST(ReadPoseWithCamera, TakesWhatOpenCvWrites)
{
    const test::TemporaryFolder folder;
    expectTurned(io::readPoseWithCamera(folder.write("camera.yml", openCvYaml)));
    expectTurned(io::readPoseWithCamera(folder.write("camera.xml", openCvXml)));
    expectTurned(io::readPoseWithCamera(folder.write("plain.yaml", plainYaml)));
    expectTurned(io::readPoseWithCamera(folder.write(
        "camera.json",
        R"({"imageSize": [512, 480], "R": [[0.6,-0.8,0],[0.8,0.6,0],[0,0,1]], "tvec": [[12.5],[-7.25],[741.0625]],
           "camera_matrix": {"type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d",
                             "data": [-2281.25, 0, 250.5, 0, 2279.5, 261.25, 0, 0, 1]}})")));
}

TEST(ReadPoseWithCamera, RotationVectorsTurnAsRodrigues)
{
    const test::TemporaryFolder folder;
    const auto read = io::readPoseWithCamera(folder.write(
        "rvec.json",
        R"({"K": [[1000,0,5],[0,1000,6],[0,0,1]], "rvec": [0, 0, 1.5707963267948966], "tvec": [1,2,700]})"));
    ASSERT_TRUE(read);
    EXPECT_LT((read.value().cameraFromPatient.rotation * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
              1e-15);
    EXPECT_EQ(read.value().camera->width, 0);   // not stated
}

TEST(WriteSight, RestoresCameraAndPose)
{
    const test::TemporaryFolder folder;
    for (const char* name : {"sight.json", "sight.yml", "sight.yaml", "sight.xml"}) {
        ASSERT_TRUE(io::writePosedCamera(oddSight, folder.file(name)));
        const auto read = io::readPoseWithCamera(folder.file(name));
        ASSERT_TRUE(read) << name << ": " << read.error().message.text();
        EXPECT_EQ(read.value().cameraFromPatient.matrix(), oddSight.cameraFromPatient.matrix()) << name;
        EXPECT_EQ(*read.value().camera, oddSight.camera) << name;
    }
    ASSERT_TRUE(io::writePosedCamera(oddSight, folder.file("sight.txt")));
    const auto projection = io::readPoseWithCamera(folder.file("sight.txt"));
    ASSERT_TRUE(projection);
    EXPECT_LT(
        (projection.value().cameraFromPatient.matrix() - oddSight.cameraFromPatient.matrix()).cwiseAbs().maxCoeff(),
        1e-9);
    EXPECT_TRUE(io::isSameCamera(*projection.value().camera, oddSight.camera));   // P does not contain the image size
    EXPECT_TRUE(
        io::writePosedCamera(oddSight, folder.file("sight.doc")).error().message.is(io::messages::exchangeExtension));
}

TEST(ReadPoseWithCamera, TakesNumbersAsTextHoweverTheyAreParted)
{
    const test::TemporaryFolder folder;
    const std::string rows = "-2000, 0, 250, 187500\n0, 2000, 240, 180000\n0, 0, 1, 750\n";
    for (const std::string& text : {rows, std::string("# P\n-2000 0 250 187500 0 2000 240 180000\n0 0 1 750"),
                                    std::string("[[-2000;0;250;187500];[0;2000;240;180000];[0;0;1;750]]")}) {
        const auto read = io::readPoseWithCamera(folder.write("p.txt", text));
        ASSERT_TRUE(read) << text;
        EXPECT_NEAR(read.value().camera->fx, -2000.0, 1e-9);
        EXPECT_LT((read.value().cameraFromPatient.translation - Eigen::Vector3d(0, 0, 750)).norm(), 1e-9);
    }
    const auto matrix = io::readPose(folder.write("pose.txt", "1 0 0 4\n0 1 0 5\n0 0 1 700\n0 0 0 1\n"));
    ASSERT_TRUE(matrix);
    EXPECT_EQ(matrix.value().translation, Eigen::Vector3d(4, 5, 700));
    EXPECT_TRUE(io::readPose(folder.write("few.txt", "1 2 3")).error().message.is(io::messages::exchangeNumbers));
}

TEST(ReadPoseWithCamera, PoseFilesBringTheirCamera)
{
    const test::TemporaryFolder folder;
    const auto both = io::readPoseWithCamera(
        folder.write("camera.json", io::cameraPoseText(oddSight.cameraFromPatient, oddSight.camera)));
    ASSERT_TRUE(both);
    EXPECT_EQ(*both.value().camera, oddSight.camera);
    ASSERT_TRUE(io::writePose(oddSight.cameraFromPatient, folder.file("pose.json")));
    EXPECT_FALSE(io::readPoseWithCamera(folder.file("pose.json")).value().camera);
}

TEST(ReadPoseWithCamera, SaysWhatIsWrong)
{
    const test::TemporaryFolder folder;
    const auto failure = [&](const std::string& name, const std::string& text) {
        const auto read = io::readPoseWithCamera(folder.write(name, text));
        return read ? core::Message::verbatim("read") : read.error().message;
    };
    const std::string skewed = R"({"K": [[1000,5,5],[0,1000,6],[0,0,1]], "R": [1,0,0,0,1,0,0,0,1], "t": [1,2,700]})";
    EXPECT_TRUE(failure("skewed.json", skewed).is(core::messages::projectionSkewed));
    EXPECT_NE(failure("skewed.json", skewed).text().find("skewed.json"), std::string::npos);
    const std::string scaled = R"({"K": [[1000,0,5],[0,1000,6],[0,0,1]], "R": [2,0,0,0,2,0,0,0,2], "t": [1,2,700]})";
    EXPECT_TRUE(failure("scaled.json", scaled).is(core::messages::projectionNoRotation));
    std::string deformed = openCvYaml;
    deformed.replace(deformed.find("[ 0., 0., 0., 0., 0. ]"), 22, "[ -0.1, 0., 0., 0., 0.]");
    EXPECT_TRUE(failure("bent.yml", deformed).is(io::messages::exchangeDistorted));
    EXPECT_TRUE(failure("empty.yml", "%YAML:1.0\n---\nsomething: 3\n").is(io::messages::exchangeNoPose));
    EXPECT_TRUE(failure("parameters.pt", "PK\x03\x04 data.pkl").is(io::messages::exchangePickle));
}

/// Truncated and altered files give a message or a rigid pose, never anything else.
TEST(ReadPoseWithCamera, DamagedTextsEndInAMessage)
{
    const test::TemporaryFolder folder;
    for (const auto& [name, whole] : {std::pair{"c.yml", openCvYaml}, {"c.xml", openCvXml}, {"c.yaml", plainYaml}}) {
        for (std::size_t at = 1; at < whole.size(); at += 3) {
            std::string changed = whole;
            changed[at] = static_cast<char>(changed[at] ^ (at % 7 + 1));
            for (const std::string& text : {whole.substr(0, at), changed}) {
                const auto read = io::readPoseWithCamera(folder.write(name, text));
                EXPECT_TRUE(!read || core::isRigid(read.value().cameraFromPatient)) << name << " at " << at;
            }
        }
    }
}

TEST(PoseCameraFile, ACameraWithoutFocalLengthIsNamedNotPassedBy)
{
    const test::TemporaryFolder folder;
    const auto readWith = [&](const std::string& fx) {
        return io::readPoseWithCamera(folder.write(
            "p.json", R"({"cameraFromPatient": [[1,0,0,0],[0,1,0,0],[0,0,1,700],[0,0,0,1]], "camera": {"fx": )" + fx +
                          R"(, "fy": 2000, "cx": 256, "cy": 256}})"));
    };
    EXPECT_TRUE(readWith("-2000").value().camera);
    const auto none = readWith("0");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.text().find("focal lengths"), std::string::npos) << none.error().message;
}

}   // namespace
