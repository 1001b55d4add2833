#include "app/document/edit_case.h"
#include "app/files/sample_case.h"
#include "tests/app/scan_window.h"
#include "tests/support/for_each.h"
#include "ui/slices/corner_views.h"
#include "ui/views/scan_bar.h"

#include <QDir>
#include <QFileInfo>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

namespace angiopose::app {
namespace {

using core::BodyPlane;
using WindowSlices = test::ScanWindow;

class WindowScanIn3d : public test::ScanWindow {
protected:
    WindowScanIn3d() { forget(); }
    ~WindowScanIn3d() override { forget(); }
    static void forget()
    {
        settings::scanIn3d.write(false);
        settings::scanPreset.write(0);
        settings::scanAtVessels.write(false);
    }

    ui::TreeView& tree() { return w.window.treeView(); }
    ui::ScanBar& bar() { return w.window.corner().scanBar(); }
    QImage settled()
    {
        for (int seen = -1; seen != tree().renderCount();) {
            seen = tree().renderCount();
            QTest::qWait(900);
        }
        return tree().grab().toImage();
    }
    static int differentPixels(const QImage& a, const QImage& b)
    {
        int count = 0;
        test::forEachPixel(a.width(), a.height(),
                           [&](int x, int y) { count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 12; });
        return count;
    }
};

TEST_F(WindowSlices, StandWhereThereIsNoAngiogramYet)
{
    EXPECT_TRUE(w.window.slicesPage().isVisible());
    EXPECT_EQ(view(BodyPlane::Axial).grid().width, 64);
    EXPECT_EQ(view(BodyPlane::Axial).grid().height, 40);
    EXPECT_EQ(view(BodyPlane::Sagittal).grid().height, 96);
    EXPECT_TRUE(model().isHounsfield());

    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_M);
    EXPECT_FALSE(w.window.slicesPage().isVisible());
    EXPECT_TRUE(w.window.angiogramView().isVisible());
    w.press(Qt::Key_M);
    EXPECT_TRUE(w.window.slicesPage().isVisible());
}

TEST_F(WindowSlices, MakeRoomForAnAngiogramThatIsOpened)
{
    ASSERT_TRUE(w.window.slicesPage().isVisible());
    const auto sample = writeSampleCase();
    ASSERT_TRUE(sample);
    w.drop({QFileInfo(sample.value()).dir().filePath(QStringLiteral("run.dcm"))});
    EXPECT_TRUE(
        test::waitFor([this] { return w.current().shown().angiogram || w.dialogs("patientQuestion").size() == 1; }));
    for (QDialog* question : w.dialogs("patientQuestion")) {   // the scan is of another patient
        test::OpenWindow::clickButton(question, QStringLiteral("Open anyway"));
    }
    ASSERT_TRUE(test::waitFor([this] { return w.current().shown().angiogram != nullptr; }));
    QApplication::processEvents();
    EXPECT_FALSE(w.window.slicesPage().isVisible());
    EXPECT_TRUE(w.window.angiogramView().isVisible());
}

TEST_F(WindowSlices, FollowWheelAndKeys)
{
    const Eigen::Vector3d start = model().crosshair();
    wheel(BodyPlane::Axial, 2);
    EXPECT_NEAR(model().crosshair().z(), start.z() + 2.0, 1e-9);
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Down);
    EXPECT_NEAR(model().crosshair().z(), start.z() + 1.0, 1e-9);
    QTest::keyClick(&view(BodyPlane::Coronal), Qt::Key_Up);
    EXPECT_NEAR(model().crosshair().y(), start.y() + 1.0, 1e-9);
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Right, Qt::ControlModifier);
    EXPECT_NEAR(model().crosshair().x(), start.x() + 1.0, 1e-9);
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Home);
    EXPECT_NEAR(model().crosshair().z(), 89.0, 1e-9);   // the top slice
    wheel(BodyPlane::Axial, 5);
    EXPECT_NEAR(model().crosshair().z(), 89.0, 1e-9);
}

TEST_F(WindowSlices, LinkTheCrosshairAndTellWhatWasPicked)
{
    model().setCrosshair({0, 0, 20});
    QApplication::processEvents();
    const QSignalSpy picked(&w.window, &ui::MainWindow::pointPicked);
    click(BodyPlane::Coronal, {-10, 0, 60});

    EXPECT_LT((model().crosshair() - Eigen::Vector3d(-10, 0, 60)).norm(), 0.5);
    EXPECT_NEAR(view(BodyPlane::Axial).grid().firstInPatient.z(), 60.0, 0.51);
    ASSERT_EQ(picked.size(), 1);
    EXPECT_LT((picked.front().front().value<Eigen::Vector3d>() - model().crosshair()).norm(), 1e-12);
}

TEST_F(WindowSlices, SelectTheBranchThatIsClickedOrHovered)
{
    const core::VesselBranch& trunk = w.current().vessels.tree->branches.front();
    const Eigen::Vector3d point = trunk.pointsInPatient[trunk.pointsInPatient.size() / 4];   // far from the bifurcation
    model().setCrosshair(point);
    QApplication::processEvents();

    QTest::mouseMove(&view(BodyPlane::Axial), placeOf(BodyPlane::Axial, point) + QPoint(40, 40));
    QTest::mouseMove(&view(BodyPlane::Axial), placeOf(BodyPlane::Axial, point));
    EXPECT_TRUE(QTest::qWaitFor([&] { return w.controller.branches().marks().hovered == trunk.id; }, 5000));
    click(BodyPlane::Axial, point);
    EXPECT_EQ(w.controller.branches().marks().selected, std::set{trunk.id});

    const core::VesselBranch& other = w.current().vessels.tree->branches.back();
    w.controller.branches().select({other.id});   // as the branch list does
    double nearest = 1e9;
    for (const Eigen::Vector3d& at : other.pointsInPatient) {
        nearest = std::min(nearest, (at - model().crosshair()).norm());
    }
    EXPECT_LT(nearest, 1.0);
}

TEST_F(WindowSlices, ChangeWindowZoomAndPlaceByMouse)
{
    const ui::GrayWindow before = model().window();
    drag(BodyPlane::Axial, Qt::RightButton, {40, 20});
    EXPECT_GT(model().window().width, before.width);
    EXPECT_GT(model().window().level, before.level);

    const QPointF corner(10, 10);
    const Eigen::Vector3d shown = view(BodyPlane::Axial).patientFromWidget(corner);
    drag(BodyPlane::Axial, Qt::MiddleButton, {30, 0});
    const Eigen::Vector3d moved = view(BodyPlane::Axial).patientFromWidget(corner);
    EXPECT_LT(moved.x(), shown.x());
    wheel(BodyPlane::Axial, 3, Qt::ControlModifier);
    EXPECT_GT(view(BodyPlane::Axial).patientFromWidget(corner).x(), moved.x());   // closer to the middle
}

TEST_F(WindowSlices, ShowOnePlaneBelowTheBranches)
{
    w.press(Qt::Key_M);
    EXPECT_TRUE(w.window.treeView().isVisible());
    w.press(Qt::Key_2);
    EXPECT_EQ(w.window.corner().shownPlane(), BodyPlane::Axial);
    EXPECT_TRUE(w.window.corner().slice().isVisible());
    EXPECT_FALSE(w.window.treeView().isVisible());
    for (QToolButton* tab : w.window.corner().findChildren<QToolButton*>()) {
        if (tab->text() == QStringLiteral("Sagittal")) {
            QTest::mouseClick(tab, Qt::LeftButton);
        }
    }
    EXPECT_EQ(w.window.corner().slice().plane(), BodyPlane::Sagittal);
    QTest::mouseDClick(&w.window.corner().slice(), Qt::LeftButton, {}, {20, 20});
    EXPECT_TRUE(w.window.slicesPage().isVisible());
    w.window.corner().showPlane(std::nullopt);
}

TEST_F(WindowSlices, GoWithTheScan)
{
    const core::Case nothing;
    w.controller.document().replace(nothing, {});
    EXPECT_FALSE(model().hasScan());
    EXPECT_FALSE(w.window.slicesPage().isVisible());
    EXPECT_FALSE(w.window.actions()[ui::Command::SlicesLarge]->isEnabled());
}

TEST_F(WindowSlices, ShowTheLandmarksWhileTheseAreClicked)
{
    const Eigen::Vector3d place = w.current().vessels.tree->branches.front().pointsInPatient.front();
    w.controller.document().push(std::make_unique<ChangeLandmarks>(
        w.controller.document(), ChangeLandmarks::Values{{core::Landmark{place, {10.0, 20.0}, ""}}},
        [] { return QStringLiteral("Click a pair"); }));
    const auto shown = [this] {
        const auto& points = model().points();
        const auto found = points.find(ui::SliceMarkKind::Landmark);
        return found == points.end() ? std::vector<ui::SliceMark>{} : found->second;
    };
    w.window.actions()[ui::Command::Landmarks]->setChecked(true);
    ASSERT_EQ(shown().size(), 1U);
    EXPECT_EQ(shown().front().pointInPatient, place);
    EXPECT_EQ(shown().front().label, QStringLiteral("1"));
    w.window.actions()[ui::Command::Landmarks]->setChecked(false);
    EXPECT_TRUE(shown().empty());
}

TEST_F(WindowScanIn3d, ShowsTheScanBehindTheVesselsAndLetsGoOfIt)
{
    w.window.corner().showPlane(std::nullopt);
    w.press(Qt::Key_A, Qt::ControlModifier);
    w.press(Qt::Key_H, Qt::ShiftModifier);   // hides the branches, which cover the vessels of the scan
    for (const bool on : {true, false}) {   // gives the bar its height
        w.window.actions()[ui::Command::ScanIn3d]->setChecked(on);
        settled();
    }
    const QImage without = settled();
    EXPECT_TRUE(bar().isVisible());
    EXPECT_FALSE(bar().findChild<QSlider*>()->isVisible());
    w.press(Qt::Key_3, Qt::ControlModifier);
    ASSERT_TRUE(w.window.actions()[ui::Command::ScanIn3d]->isChecked());
    ASSERT_TRUE(test::waitFor([this] { return w.controller.scan().isShown(); }));
    const QImage vessels = settled();
    EXPECT_GT(differentPixels(without, vessels), 100);
    EXPECT_TRUE(bar().findChild<QSlider*>()->isVisible());

    w.press(Qt::Key_4, Qt::ControlModifier);   // also shows everything else of the same brightness
    settled();
    bar().findChild<QSlider*>()->setValue(100);
    const QImage strong = settled();
    bar().findChild<QSlider*>()->setValue(0);
    EXPECT_GT(differentPixels(strong, settled()), 100);

    w.press(Qt::Key_3, Qt::ControlModifier);
    EXPECT_LT(differentPixels(without, settled()), 20);
    w.press(Qt::Key_3, Qt::ControlModifier);
    settled();
    w.controller.document().replace({}, {});   // closes the case
    QTest::qWait(200);
    EXPECT_FALSE(w.window.actions()[ui::Command::ScanIn3d]->isEnabled());
    EXPECT_FALSE(bar().isVisible());
}

TEST_F(WindowScanIn3d, TurnsWithTheViewAndIsRememberedForTheNextWindow)
{
    w.window.corner().showPlane(std::nullopt);
    w.press(Qt::Key_3, Qt::ControlModifier);
    w.press(Qt::Key_5, Qt::ControlModifier);
    const QImage before = settled();
    const QPoint middle = tree().rect().center();
    QTest::mousePress(&tree(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(&tree(), middle + QPoint(30, 0));
    QTest::mouseMove(&tree(), middle + QPoint(140, 0));
    QTest::mouseRelease(&tree(), Qt::LeftButton, {}, middle + QPoint(140, 0));
    EXPECT_GT(differentPixels(before, settled()), 100);
    test::OpenWindow later;
    EXPECT_TRUE(later.window.actions()[ui::Command::ScanIn3d]->isChecked());
    EXPECT_TRUE(later.window.actions()[ui::Command::ScanAtVessels]->isChecked());
}

}   // namespace
}   // namespace angiopose::app
