#include "tests/app/beside_window.h"
#include "tests/support/temporary_folder.h"

#include "core/case/case_views.h"
#include "core/case/registration_input.h"
#include "core/workflow/pose_evaluation.h"
#include "ui/places/side_by_side.h"

#include <QListWidget>
#include <QScrollBar>
#include <QToolButton>
#include <QWheelEvent>

namespace angiopose::app {
namespace {

using test::BesideWindow;
using test::simulatedViews;

TEST(WindowSideBySide, ShowsTheOtherViewWithItsOwnFrameGeometryAndPose)
{
    BesideWindow w;
    ASSERT_EQ(w.images().paneCount(), 1U);
    EXPECT_TRUE(w.images().pane(0).isVisible());
    EXPECT_EQ(w.images().pane(0).title().title(), QStringLiteral("2 · second"));
    EXPECT_EQ(w.images().title().title(), QStringLiteral("1 · first"));
    EXPECT_TRUE(w.images().title().isVisible());
    const core::View& second = w.current().views[1];
    EXPECT_EQ(w.other().cameraFromPatient().matrix(), second.cameraFromPatient.matrix());
    EXPECT_EQ(w.other().camera(), *second.geometry.cameraOverride);
    EXPECT_EQ(w.other().scene().frame().pixels,
              second.angiogram->frames[static_cast<std::size_t>(second.frame)].pixels);
    EXPECT_EQ(w.other().scene().content().tree.branches.size(), w.current().vessels.tree->branches.size());
    EXPECT_EQ(w.image().cameraFromPatient().matrix(), w.poseOf(0).matrix());
    EXPECT_GE(w.other().mapTo(&w.window, QPoint()).x(), w.image().mapTo(&w.window, QPoint(w.image().width(), 0)).x());

    w.press(Qt::Key_6);
    EXPECT_EQ(w.images().paneCount(), 0U);
    EXPECT_FALSE(w.images().title().isVisible());
    EXPECT_FALSE(settings::sideBySide.read());
    EXPECT_FALSE(w.controller.document().isModified() && w.history().canUndo()) << "how it is shown is no edit";
}

TEST(WindowSideBySide, IsRememberedAndHasAButtonBesideTheSmallPictures)
{
    {
        BesideWindow w;
    }
    test::OpenWindow again;
    again.controller.document().replace(simulatedViews(), {});
    QApplication::processEvents();
    EXPECT_EQ(again.window.sideBySide().paneCount(), 1U);
    for (auto* button : again.window.views().findChildren<QToolButton*>()) {
        if (button->text() == QStringLiteral("Side by side")) {
            EXPECT_TRUE(button->isChecked());
            QTest::mouseClick(button, Qt::LeftButton);
        }
    }
    EXPECT_EQ(again.window.sideBySide().paneCount(), 0U);
    EXPECT_FALSE(again.window.actions()[ui::Command::SideBySide]->isChecked());
}

TEST(WindowSideBySide, OneViewSaysWhyNothingStandsBesideIt)
{
    test::SampleWindow w;
    w.press(Qt::Key_6);
    EXPECT_EQ(w.window.sideBySide().paneCount(), 0U);
    ASSERT_FALSE(w.window.strip().reported().all().empty());
    const QString reported = w.window.strip().reported().all().back().text;
    EXPECT_TRUE(reported.contains(QStringLiteral("one view"))) << reported.toStdString();
    EXPECT_TRUE(reported.contains(QStringLiteral("Ctrl+Shift+V")));
    EXPECT_FALSE(w.window.sideBySide().title().isVisible());
}

TEST(WindowSideBySide, ADoubleClickOrAClickOnTheNameMakesItTheShownView)
{
    BesideWindow w;
    const auto first = w.current().views[0].angiogram;
    const auto second = w.current().views[1].angiogram;
    QTest::mouseDClick(&w.other(), Qt::LeftButton, {}, w.other().rect().center());
    EXPECT_EQ(w.current().shownView, 1U);
    EXPECT_EQ(w.image().scene().frame().pixels,
              second->frames[static_cast<std::size_t>(w.current().shown().frame)].pixels);
    EXPECT_EQ(w.images().title().title(), QStringLiteral("2 · second"));
    EXPECT_EQ(w.images().pane(0).title().title(), QStringLiteral("1 · first"));
    EXPECT_EQ(w.other().cameraFromPatient().matrix(), w.poseOf(0).matrix());
    EXPECT_TRUE(w.image().hasFocus());

    QTest::mouseClick(&w.images().pane(0).title(), Qt::LeftButton);
    EXPECT_EQ(w.current().shownView, 0U);
    QTest::mouseClick(&w.images().title(), Qt::LeftButton);   // the view that is already shown: no change
    EXPECT_EQ(w.current().shownView, 0U);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().shownView, 0U);
    EXPECT_EQ(w.images().pane(0).title().title(), QStringLiteral("2 · second"));
    EXPECT_EQ(w.current().shown().angiogram, first);
}

TEST(WindowSideBySide, TheChosenOneChangesPlacesWithTheShownOneAndTakesItsZoomAlong)
{
    BesideWindow w(simulatedViews(4));
    w.other(1).zoomTo({100.0, 140.0, 100.0, 140.0});
    const double middle = 0.5 * (w.other(1).visiblePart().left + w.other(1).visiblePart().right);
    ASSERT_TRUE(w.image().isFitted());
    QTest::mouseDClick(&w.other(1), Qt::LeftButton, {}, w.other(1).rect().center());
    EXPECT_EQ(w.current().shownView, 2U);
    EXPECT_EQ(w.images().pane(0).title().title(), QStringLiteral("2 · second"));
    EXPECT_EQ(w.images().pane(1).title().title(), QStringLiteral("1 · first"));
    EXPECT_EQ(w.images().pane(2).title().title(), QStringLiteral("4 · fourth"));
    EXPECT_TRUE(w.other(1).isFitted());
    EXPECT_NEAR(0.5 * (w.image().visiblePart().left + w.image().visiblePart().right), middle, 1e-6);
}

TEST(WindowSideBySide, AnotherViewFollowsADragThatIsUnderWay)
{
    BesideWindow w;
    const core::RigidTransform before = w.poseOf(1);
    w.drag({30, 16});
    const core::RigidTransform dragged = w.controller.preview().pose();
    ASSERT_GT(test::distance(dragged, w.poseOf(0)), 0.5);
    EXPECT_EQ(w.image().cameraFromPatient().matrix(), dragged.matrix());
    EXPECT_EQ(w.other().cameraFromPatient().matrix(), core::poseAfterMotion(w.current(), 1, dragged).matrix());
    EXPECT_GT(test::distance(w.other().cameraFromPatient(), before), 0.1);
    EXPECT_EQ(test::distance(w.poseOf(1), before), 0.0) << "the case waits for the end of the drag";
    w.press(Qt::Key_Escape);
    EXPECT_EQ(w.other().cameraFromPatient().matrix(), before.matrix());
    QTest::mouseRelease(&w.image(), Qt::LeftButton);

    w.press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_GT(test::distance(w.other().cameraFromPatient(), before), 0.1);
    EXPECT_EQ(w.other().cameraFromPatient().matrix(), w.poseOf(1).matrix());
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.other().cameraFromPatient().matrix(), before.matrix());
}

TEST(WindowSideBySide, PosesThatAreIndependentStayAndSaySo)
{
    BesideWindow w;
    const ui::PaneTitle& title = w.images().pane(0).title();
    EXPECT_EQ(title.note(), QStringLiteral("linked"));
    w.setTogether(false);
    EXPECT_EQ(title.note(), QStringLiteral("independent pose"));
    const core::RigidTransform before = w.poseOf(1);
    const QPoint to = w.drag({30, 16});
    EXPECT_GT(test::distance(w.image().cameraFromPatient(), w.poseOf(0)), 0.5);
    EXPECT_EQ(w.other().cameraFromPatient().matrix(), before.matrix());
    QTest::mouseRelease(&w.image(), Qt::LeftButton, {}, to);
    EXPECT_EQ(w.other().cameraFromPatient().matrix(), before.matrix());
    w.setTogether(true);
    EXPECT_EQ(title.note(), QStringLiteral("linked"));
}

TEST(WindowSideBySide, ColorsTellHowEachPoseAgreesWithItsOwnImage)
{
    BesideWindow w;
    const auto residuals = [&]() -> const std::map<int, std::vector<double>>& {
        return w.other().scene().content().residualPx;
    };
    ASSERT_TRUE(test::waitFor([&] { return !residuals().empty(); }));
    const core::View& second = w.current().views[1];
    const auto expectedAt = [&](const core::RigidTransform& pose) {
        const auto input = core::makeRegistrationInput(second, w.current().vessels, *second.target.centerline);
        return core::evaluateWithResiduals(input.value(), pose).value().residualPx;
    };
    EXPECT_EQ(residuals(), expectedAt(second.cameraFromPatient));
    EXPECT_NE(residuals(), w.image().scene().content().residualPx);

    w.press(Qt::Key_N);
    w.press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_TRUE(test::waitFor([&] { return residuals() == expectedAt(w.poseOf(1)); }));
}

TEST(WindowSideBySide, EachHasItsOwnFrame)
{
    BesideWindow w;
    const int shownFrame = w.current().shown().frame;
    w.other().setFocus();
    QTest::keyClick(&w.other(), Qt::Key_Home);
    EXPECT_EQ(w.current().views[1].frame, 0);
    EXPECT_EQ(w.current().shown().frame, shownFrame);
    EXPECT_EQ(w.other().scene().frame().pixels, w.current().views[1].angiogram->frames[0].pixels);
    QWheelEvent wheel(QPointF(20, 20), w.other().mapToGlobal(QPointF(20, 20)), {}, {0, -120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&w.other(), &wheel);
    EXPECT_EQ(w.current().views[1].frame, 1);
    auto* bar = w.images().pane(0).findChild<QScrollBar*>();
    EXPECT_TRUE(bar->isVisible());
    EXPECT_EQ(bar->value(), 1);
    QTest::keyClick(bar, Qt::Key_End);
    EXPECT_EQ(w.current().views[1].frame, 2);
    QTest::keyClick(&w.other(), Qt::Key_Down);   // there is none after the last
    EXPECT_EQ(w.current().views[1].frame, 2);
    w.press(Qt::Key_Z, Qt::ControlModifier);   // changes in quick succession are one undo step
    EXPECT_NE(w.current().views[1].frame, 2);
    EXPECT_EQ(bar->value(), w.current().views[1].frame);
    EXPECT_FALSE(w.history().canUndo());
}

TEST(WindowSideBySide, EachHasItsOwnBrightnessAndZoom)
{
    BesideWindow w;
    const double level = w.image().shownRange().level();
    const double zoom = w.image().zoom();
    w.other().setWindowLevel(0.5, 0.25);
    QTest::mouseClick(&w.other(), Qt::LeftButton, {}, {5, 5});
    ASSERT_TRUE(w.other().hasFocus());
    QTest::keyClick(&w.other(), Qt::Key_7);   // keys act on the image with the focus
    EXPECT_DOUBLE_EQ(w.other().shownRange().window(), 1.0);
    EXPECT_DOUBLE_EQ(w.image().shownRange().level(), level);
    w.other().zoomTo({100.0, 140.0, 100.0, 140.0});
    EXPECT_EQ(w.image().zoom(), zoom);
    QTest::keyClick(&w.other(), Qt::Key_1);
    EXPECT_TRUE(w.other().isFitted());
    w.image().setFocus();
    w.press(Qt::Key_I);   // display modes of overlay and image apply to all views
    w.press(Qt::Key_T);
    EXPECT_TRUE(w.other().scene().content().frame.isInverted());
    EXPECT_TRUE(w.other().scene().content().isTracedShown);
    w.press(Qt::Key_I);
    w.press(Qt::Key_T);
}

TEST(WindowSideBySide, ViewsComeAndGoWithTheCase)
{
    BesideWindow w(simulatedViews(4));
    ASSERT_EQ(w.images().paneCount(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = i + 1; k < 3; ++k) {
            EXPECT_FALSE(w.images().pane(i).geometry().intersects(w.images().pane(k).geometry()));
        }
        EXPECT_EQ(w.other(i).cameraFromPatient().matrix(), w.poseOf(i + 1).matrix());
    }
    auto& strip = *w.window.views().findChild<QListWidget*>();
    strip.setFocus();
    QTest::keyClick(&strip, Qt::Key_Delete);   // removes the shown view
    ASSERT_EQ(w.current().views.size(), 3U);
    ASSERT_EQ(w.images().paneCount(), 2U);
    EXPECT_EQ(w.images().title().title(), QStringLiteral("1 · second"));
    EXPECT_EQ(w.images().pane(1).title().title(), QStringLiteral("3 · fourth"));
    QTest::keyClick(&strip, Qt::Key_Delete);
    QTest::keyClick(&strip, Qt::Key_Delete);
    EXPECT_EQ(w.images().paneCount(), 0U);
    EXPECT_FALSE(w.images().title().isVisible());
    for (int i = 0; i < 3; ++i) {
        w.press(Qt::Key_Z, Qt::ControlModifier);
    }
    ASSERT_EQ(w.images().paneCount(), 3U);
    EXPECT_EQ(w.other(2).cameraFromPatient().matrix(), w.poseOf(3).matrix());
    EXPECT_TRUE(w.images().pane(2).isVisible());
}

TEST(WindowSideBySide, NothingOfAClosedCaseIsKept)
{
    BesideWindow w;
    ASSERT_TRUE(test::waitFor([&w] { return !w.other().scene().content().residualPx.empty(); }));
    const std::weak_ptr<const core::VesselTree> tree = w.current().vessels.tree;
    const std::weak_ptr<const core::Angiogram> other = w.current().views[1].angiogram;
    w.controller.document().replace({}, {});
    EXPECT_EQ(w.images().paneCount(), 0U);
    EXPECT_TRUE(test::waitFor([&] { return tree.expired() && other.expired(); }))
        << tree.use_count() << " " << other.use_count();
}

TEST(WindowSideBySide, ABlindTrialHidesThem)
{
    BesideWindow w;
    const test::TemporaryFolder folder;
    w.waitForJudgement();
    w.controller.poses().blindTrial().start(
        {QStringLiteral("Ada"), 7, 10.0, 5.0, QString::fromStdString(folder.file("trials.csv"))});
    EXPECT_EQ(w.images().paneCount(), 0U);
    w.controller.poses().blindTrial().abandon();
    EXPECT_EQ(w.images().paneCount(), 1U);
}

}   // namespace
}   // namespace angiopose::app
