#include "app/document/edit_case.h"
#include "app/document/with_geometry.h"
#include "tests/app/open_window.h"
#include "tests/support/test_data.h"

#include <QAbstractButton>
#include <QDialog>
#include <QImage>
#include <QLabel>
#include <QTemporaryDir>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::OpenWindow;

void openRegisteredRun(OpenWindow& w)
{
    w.drop({QString::fromStdString(test::dataFile("coronary-phantom-xa/cases/IM4.angiopose").string())});
    w.waitForJudgement();
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
}

void follow(OpenWindow& w)
{
    w.press(Qt::Key_F, Qt::ShiftModifier);
    ASSERT_TRUE(w.controller.tracking().isRunning());
    EXPECT_TRUE(test::waitFor([&] { return !w.controller.tracking().isRunning(); }));
    QApplication::processEvents();
}

const core::TrackedRunFrame& followed(OpenWindow& w, int frame)
{
    return w.controller.tracking().frames().at(static_cast<std::size_t>(frame));
}

bool says(OpenWindow& w, const QString& words)
{
    const auto labels = w.window.result().findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&words](const QLabel* label) { return label->text().contains(words); });
}

TEST(WindowFollow, ShowsEachFrameWithItsOwnPose)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openRegisteredRun(w);
    const int first = w.current().shown().frame;
    const Eigen::Matrix4d found = w.current().shown().cameraFromPatient.matrix();
    EXPECT_FALSE(w.window.result().motion().isVisible());
    follow(w);
    ASSERT_EQ(w.controller.tracking().frames().size(), 10U);
    EXPECT_EQ(w.current().shown().cameraFromPatient.matrix(), found);
    EXPECT_TRUE(w.window.result().motion().isVisible());

    w.press(Qt::Key_Down);
    const int next = w.current().shown().frame;
    ASSERT_EQ(next, first + 1);
    EXPECT_EQ(w.current().shown().cameraFromPatient.matrix(), followed(w, next).tracked.cameraFromPatient.matrix());
    EXPECT_TRUE(test::waitFor([&] { return says(w, QStringLiteral("· tracked")); }));
    w.press(Qt::Key_Up);
    EXPECT_EQ(w.current().shown().cameraFromPatient.matrix(), found);
    EXPECT_EQ(w.controller.tracking().frames().size(), 10U);   // they remain valid
}

TEST(WindowFollow, AClickInThePlotShowsThatFrame)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openRegisteredRun(w);
    follow(w);
    ui::MotionPlot& plot = w.window.result().motion();
    QTest::mouseClick(&plot, Qt::LeftButton, {}, {plot.width() - 5, plot.height() / 2});
    EXPECT_EQ(w.current().shown().frame, 9);
    EXPECT_EQ(w.current().shown().cameraFromPatient.matrix(), followed(w, 9).tracked.cameraFromPatient.matrix());
    plot.setFocus();
    QTest::keyClick(&plot, Qt::Key_Left);
    EXPECT_EQ(w.current().shown().frame, 8);
}

TEST(WindowFollow, PosesAreForgottenWhenTheVesselsAreMoved)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openRegisteredRun(w);
    follow(w);
    EXPECT_TRUE(w.window.actions()[ui::Command::ExportTrackedPoses]->isEnabled());
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    EXPECT_TRUE(w.controller.tracking().frames().empty());
    EXPECT_FALSE(w.window.result().motion().isVisible());
    EXPECT_FALSE(w.window.actions()[ui::Command::ExportTrackedPoses]->isEnabled());
    const Eigen::Matrix4d nudged = w.current().shown().cameraFromPatient.matrix();
    w.press(Qt::Key_N);
    w.press(Qt::Key_Down);
    EXPECT_EQ(w.current().shown().cameraFromPatient.matrix(), nudged);   // all frames share one pose again
}

void followSample(OpenWindow& w)
{
    w.openSample();
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    follow(w);
    ASSERT_FALSE(w.controller.tracking().frames().empty());
}

TEST(WindowFollow, IsAStepOfUndo)
{
    OpenWindow w;
    followSample(w);
    const auto frames = w.current().shown().followed.frames;
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    EXPECT_TRUE(w.controller.tracking().frames().empty());
    w.press(Qt::Key_N);
    w.controller.document().undo();
    EXPECT_EQ(w.current().shown().followed.frames, frames) << "with the pose that it went from";
    EXPECT_TRUE(w.window.result().motion().isVisible());
    w.controller.document().undo();
    EXPECT_TRUE(w.controller.tracking().frames().empty());
    EXPECT_FALSE(w.window.result().motion().isVisible());
    EXPECT_FALSE(w.window.actions()[ui::Command::ExportTrackedPoses]->isEnabled());
    w.controller.document().redo();
    EXPECT_EQ(w.current().shown().followed.frames, frames);
    EXPECT_TRUE(w.window.actions()[ui::Command::ExportTrackedPoses]->isEnabled());
}

TEST(WindowFollow, GoesWhereTheResultGoes)
{
    OpenWindow w;
    followSample(w);
    const auto isGoneWith = [&w](auto edit) {
        edit();
        const bool isGone = !w.current().shown().followed.frames && !w.current().shown().result;
        w.controller.document().undo();
        return isGone && w.current().shown().followed.frames && w.current().shown().result;
    };
    CaseDocument& document = w.controller.document();
    core::Case wider = w.current();
    wider.shown().geometry.cArm.sourceToDetectorMm = {1234.0, core::Origin::User, ""};
    EXPECT_TRUE(isGoneWith([&] {
        document.push(changeGeometry(document, replaceGeometry(document.current(), wider.shown().geometry.cArm),
                                     [] { return QStringLiteral("geometry"); }));
    }));
    EXPECT_TRUE(
        isGoneWith([&] { w.controller.branches().toggleExcluded({w.current().vessels.tree->branches.back().id}); }));
    EXPECT_TRUE(isGoneWith([&] {
        document.push(editTree(document, *document.current().vessels.tree, [] { return QStringLiteral("tree"); }));
    }));
    core::TraceOptions tracing = w.current().shown().traceOptions;
    tracing.sensitivity = 1.5;
    EXPECT_TRUE(isGoneWith([&] {
        document.push(std::make_unique<ChangeTracing>(document, ChangeTracing::Values{tracing, std::nullopt, {}},
                                                      [] { return QStringLiteral("tracing"); }));
    }));
}

TEST(WindowFollow, ReopensAsItWasLeft)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("followed.angiopose"));
    std::vector<core::TrackedRunFrame> kept;
    {
        OpenWindow w;
        followSample(w);
        kept = w.controller.tracking().frames();
        w.controller.document().replace(w.current(), {});   // otherwise saving would overwrite the sample
        w.press(Qt::Key_S, Qt::ControlModifier);
        w.saveAs(path);
        EXPECT_TRUE(test::waitFor([&w] { return !w.controller.document().isModified(); }));
    }
    OpenWindow again;
    again.drop({path});
    again.waitForJudgement();
    EXPECT_FALSE(again.controller.document().isModified());
    ASSERT_EQ(again.controller.tracking().frames().size(), kept.size());
    EXPECT_TRUE(again.window.result().motion().isVisible());
    EXPECT_TRUE(again.window.actions()[ui::Command::ExportTrackedPoses]->isEnabled());
    const int first = again.current().shown().frame;
    again.press(Qt::Key_Down);
    ASSERT_EQ(again.current().shown().frame, first + 1);
    EXPECT_EQ(again.current().shown().cameraFromPatient.matrix(),
              kept.at(static_cast<std::size_t>(first + 1)).tracked.cameraFromPatient.matrix());
    EXPECT_TRUE(test::waitFor([&] { return says(again, QStringLiteral("· tracked")); }));
    const auto* step = again.window.steps().findChildren<QAbstractButton*>().at(static_cast<int>(ui::Step::Register));
    EXPECT_TRUE(step->accessibleName().contains(QStringLiteral("tracked"))) << qPrintable(step->accessibleName());
    again.press(Qt::Key_Up);
    again.window.actions()[ui::Command::Cine]->setChecked(true);
    EXPECT_TRUE(test::waitFor([&] { return again.controller.preview().shown() == PreviewSource::Frame; }));
}

TEST(WindowFollow, AForgottenPoseDoesNotStayOnScreen)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openRegisteredRun(w);
    follow(w);
    w.window.actions()[ui::Command::Cine]->setChecked(true);
    ASSERT_TRUE(test::waitFor([&] { return w.controller.preview().shown() == PreviewSource::Frame; }));
    w.controller.branches().toggleExcluded({w.current().vessels.tree->branches.back().id});   // invalidates the frames
    EXPECT_TRUE(w.controller.tracking().frames().empty());
    EXPECT_FALSE(w.controller.preview().shown());
}

TEST(WindowFollow, StopKeepsTheFramesItCameTo)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openRegisteredRun(w);
    w.press(Qt::Key_F, Qt::ShiftModifier);
    ASSERT_TRUE(w.controller.tracking().isRunning());
    emit w.window.strip().stopRequested();
    EXPECT_TRUE(test::waitFor([&] { return !w.controller.tracking().isRunning(); }));
    QApplication::processEvents();
    EXPECT_GE(w.controller.tracking().frames().size(), 1U);
    EXPECT_LT(w.controller.tracking().frames().size(), 10U);
}

TEST(WindowFollow, LetsGoOfACaseThatItCouldNotFollow)
{
    test::SampleWindow w;
    core::Case given = w.current();
    given.shown().target.centerline = std::make_shared<const core::Centerline2d>(
        core::Centerline2d{{{0, {{10.0, 10.0}, {90.0, 90.0}}, {}}}});   // not traced, so tracking cannot start
    w.controller.document().replace(std::move(given), {});
    const std::weak_ptr<const core::Angiogram> run = w.current().shown().angiogram;
    w.press(Qt::Key_F, Qt::ShiftModifier);
    ASSERT_TRUE(test::waitFor([&] { return !w.controller.tracking().isRunning(); }));
    QApplication::processEvents();
    EXPECT_TRUE(w.controller.tracking().frames().empty());
    for (QWidget* top : QApplication::topLevelWidgets()) {
        if (auto* dialog = qobject_cast<QDialog*>(top); dialog && dialog->isVisible()) {
            dialog->reject();   // closes the error message
        }
    }
    w.controller.document().replace({}, {});
    EXPECT_TRUE(test::waitFor([&] { return run.expired(); })) << run.use_count();
}

TEST(WindowFollow, OneFrameIsNothingToFollow)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("one.png"));
    QImage picture(64, 48, QImage::Format_Grayscale8);
    picture.fill(120);
    picture.setPixel(20, 20, qRgb(30, 30, 30));
    ASSERT_TRUE(picture.save(path));
    OpenWindow w;
    w.drop({path});
    ASSERT_TRUE(test::waitFor([&w] { return w.current().shown().angiogram != nullptr; }));
    ASSERT_EQ(w.current().shown().angiogram->frameCount(), 1);
    EXPECT_FALSE(w.window.actions()[ui::Command::TrackVessels]->isEnabled());
}

}   // namespace
}   // namespace angiopose::app
