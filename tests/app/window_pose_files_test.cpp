#include "io/camera_pose_file.h"
#include "io/fiducial_file.h"
#include "io/pose_camera_file.h"
#include "io/pose_file.h"
#include "io/support/atomic_file.h"
#include "tests/app/open_window.h"
#include "ui/panels/bottom_strip.h"

#include <QLabel>
#include <QTemporaryDir>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::OpenWindow;

class WindowPoseFiles : public ::testing::Test {
protected:
    void SetUp() override
    {
        w.openSample();
        camera = core::cameraOf(w.current().shown()).value();
        before = w.current().shown().cameraFromPatient;
        moved = before;
        moved.translation += Eigen::Vector3d(4.0, -3.0, 10.0);
    }
    QString path(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
    std::string file(const char* name) const { return path(name).toStdString(); }
    void expectTaken()
    {
        EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, moved), 1e-9);
        EXPECT_TRUE(w.dialogs("messageDialog").isEmpty());
        w.window.actions()[ui::Command::Undo]->trigger();   // not by key: a closing dialog keeps the focus for a while
        EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, before), 0.0);
    }
    bool isKnown(const QString& words)
    {
        const auto* strip = w.window.findChild<ui::BottomStrip*>();
        return test::waitFor([strip, &words] {
            const auto& reported = strip->reported().all();
            return std::ranges::any_of(reported, [&words](const auto& each) { return each.text.contains(words); });
        });
    }
    QString refusal()
    {
        QString words;
        for (QDialog* dialog : w.dialogs("messageDialog")) {
            for (const QLabel* label : dialog->findChildren<QLabel*>()) {
                words += label->text() + QLatin1Char('\n');
            }
            dialog->close();
        }
        return words;
    }

    QTemporaryDir folder;
    OpenWindow w;
    core::ProjectionCamera camera;
    core::RigidTransform before, moved;
};

TEST_F(WindowPoseFiles, BecomeThePoseOfTheShownViewAsAStepOfUndo)
{
    ASSERT_TRUE(io::writePose(moved, file("pose.tfm")));
    ASSERT_TRUE(io::writePose(moved, file("pose.h5")));
    ASSERT_TRUE(io::writePose(moved, file("pose.json")));
    ASSERT_TRUE(io::writePosedCamera({camera, moved}, file("camera.yml")));
    ASSERT_TRUE(io::writePosedCamera({camera, moved}, file("camera.txt")));
    for (const char* name : {"pose.tfm", "pose.h5", "pose.json", "camera.yml", "camera.txt"}) {
        w.drop({path(name)});
        expectTaken();
    }
    EXPECT_FALSE(w.current().shown().geometry.cameraOverride);
}

TEST_F(WindowPoseFiles, AskWhoseCameraCountsWhereTheyBringAnother)
{
    core::ProjectionCamera other = camera;
    other.fx *= 1.05;
    other.fy *= 1.05;
    ASSERT_TRUE(io::writePosedCamera({other, moved}, file("other.yml")));
    w.drop({path("other.yml")});
    ASSERT_EQ(w.dialogs("cameraQuestion").size(), 1);
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, before), 0.0);   // nothing without confirmation
    OpenWindow::clickButton(w.dialogs("cameraQuestion").front(), QStringLiteral("Cancel"));
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, before), 0.0);

    w.drop({path("other.yml")});
    OpenWindow::clickButton(w.dialogs("cameraQuestion").front(), QStringLiteral("Use pose only"));
    EXPECT_FALSE(w.current().shown().geometry.cameraOverride);
    expectTaken();

    w.drop({path("other.yml")});
    OpenWindow::clickButton(w.dialogs("cameraQuestion").front(), QStringLiteral("Use pose and camera"));
    ASSERT_TRUE(w.current().shown().geometry.cameraOverride);
    EXPECT_NEAR(w.current().shown().geometry.cameraOverride->fx, other.fx, 1e-9);
    expectTaken();
    EXPECT_FALSE(w.current().shown().geometry.cameraOverride);
}

TEST_F(WindowPoseFiles, AreRefusedWithASentenceWhereTheyDoNotFit)
{
    core::ProjectionCamera mirrored = camera;
    mirrored.fx = -camera.fx;
    ASSERT_TRUE(io::writePosedCamera({mirrored, moved}, file("mirrored.yml")));
    w.drop({path("mirrored.yml")});
    EXPECT_TRUE(refusal().contains(QStringLiteral("mirrored")));

    core::ProjectionCamera large = camera;
    large.width *= 2;
    ASSERT_TRUE(io::writePosedCamera({large, moved}, file("large.yml")));
    w.drop({path("large.yml")});
    EXPECT_TRUE(refusal().contains(QString::number(large.width)));

    ASSERT_TRUE(io::writePose(moved.inverse(), file("inverse.tfm")));
    w.drop({path("inverse.tfm")});
    const bool isBehind = (moved.inverse() * core::centroidInPatient(*w.current().vessels.tree)).z() < 1.0;
    EXPECT_EQ(refusal().contains(QStringLiteral("behind")), isBehind);

    core::RigidTransform behind = moved;
    behind.translation.z() = -900.0;
    ASSERT_TRUE(io::writePose(behind, file("behind.tfm")));
    w.drop({path("behind.tfm")});
    EXPECT_TRUE(refusal().contains(QStringLiteral("behind")));
    ASSERT_TRUE(io::writeAtomically(file("damaged.tfm"), "#Insight Transform File V1.0\nTransform: nothing\n"));
    w.drop({path("damaged.tfm")});
    EXPECT_FALSE(refusal().isEmpty());
}

TEST_F(WindowPoseFiles, OfAResultSayWhereItWasFoundWithOtherInputs)
{
    const auto result = [this](const std::string& hash) {
        std::string text = io::cameraPoseText(moved, camera);
        text.insert(text.rfind('}'), R"(, "inputs": {"angiogram": {"file": "run.dcm", "sha256": ")" + hash + R"("}})");
        return text;
    };
    ASSERT_TRUE(io::writeAtomically(file("result.json"), result(std::string(64, 'a'))));
    w.drop({path("result.json")});
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, moved), 1e-9);
    EXPECT_TRUE(isKnown(QStringLiteral("a different angiogram")));
}

TEST(WindowPoseFilesAlone, NeedACase)
{
    const QTemporaryDir folder;
    OpenWindow w;
    const QString path = folder.filePath(QStringLiteral("pose.tfm"));
    ASSERT_TRUE(io::writePose({}, path.toStdString()));
    w.drop({path});
    EXPECT_EQ(w.dialogs("messageDialog").size(), 1);
    EXPECT_TRUE(w.controller.document().isEmpty());
}

TEST_F(WindowPoseFiles, PointsOfSlicerBecomeCheckPoints)
{
    const Eigen::Vector3d place = w.current().vessels.tree->branches.front().pointsInPatient.front();
    const std::size_t marks = w.current().vessels.marks.size();
    ASSERT_TRUE(io::writeFiducials({{place, "ostium", ""}, {place, "", ""}}, file("points.fcsv")));
    w.drop({path("points.fcsv")});
    ASSERT_EQ(w.current().vessels.marks.size(), marks + 2);
    EXPECT_EQ(w.current().vessels.marks[marks].name, "ostium");
    EXPECT_EQ(w.current().vessels.marks[marks].pointInPatient, place);
    EXPECT_NE(w.current().vessels.marks[marks].id, w.current().vessels.marks[marks + 1].id);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vessels.marks.size(), marks);
}

TEST_F(WindowPoseFiles, AreExportedWithTheirCamera)
{
    w.window.actions()[ui::Command::ExportPose]->trigger();
    w.saveAs(path("out.yml"));
    const auto read = io::readPoseWithCamera(file("out.yml"));
    ASSERT_TRUE(read && read.value().camera);
    EXPECT_EQ(*read.value().camera, camera);
    EXPECT_LT(test::distance(read.value().cameraFromPatient, before), 1e-12);
}

}   // namespace
}   // namespace angiopose::app
