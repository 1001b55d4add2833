#include "app/document/edit_case.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/app/open_window.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/temporary_folder.h"
#include "ui/slices/corner_views.h"
#include "ui/slices/slices_page.h"

#include <QCheckBox>
#include <QListWidget>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>

namespace app {
namespace {

using core::BodyPlane;
using test::OpenWindow;

/// A window with the scan of a forked vessel, traced.
class WindowSlices : public ::testing::Test {
protected:
    void SetUp() override
    {
        scanPath = folder.filePath(QStringLiteral("scan.nrrd"));
        ASSERT_TRUE(io::writeVolume(test::forkScan(), scanPath.toStdString()));
        w.drop({scanPath});
        ASSERT_TRUE(w.current().volume);
        QApplication::processEvents();
    }

    ui::SliceModel& model() { return w.window.slices(); }
    ui::SliceView& view(BodyPlane plane) { return w.window.slicesPage().view(plane); }
    QPoint placeOf(BodyPlane plane, const Eigen::Vector3d& point)
    {
        return view(plane).widgetFromPatient(point).toPoint();
    }
    void click(BodyPlane plane, const Eigen::Vector3d& point)
    {
        QTest::mouseClick(&view(plane), Qt::LeftButton, Qt::NoModifier, placeOf(plane, point));
    }
    void wheel(BodyPlane plane, int steps, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        const QPointF at = view(plane).rect().center();
        QWheelEvent event(at, view(plane).mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view(plane), &event);
    }
    void drag(BodyPlane plane, Qt::MouseButton button, const QPoint& by)
    {
        const QPoint from = view(plane).rect().center();
        QTest::mousePress(&view(plane), button, Qt::NoModifier, from);
        QTest::mouseMove(&view(plane), from + by / 2);
        QTest::mouseMove(&view(plane), from + by);
        QTest::mouseRelease(&view(plane), button, Qt::NoModifier, from + by);
    }
    template <class Button>
    void press(const QString& text)
    {
        for (Button* button : w.window.tracing().findChildren<Button*>()) {
            if (button->text() == text) {
                QTest::mouseClick(button, Qt::LeftButton, {}, {10, button->height() / 2});
                return;
            }
        }
        FAIL() << "no button " << text.toStdString();
    }
    bool waitForTrace()
    {
        return QTest::qWaitFor([this] { return !w.controller.tracing().isRunning(); }, test::patienceMs);
    }

    QTemporaryDir folder;
    QString scanPath;
    OpenWindow w;
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
    EXPECT_NEAR(model().crosshair().z(), 89.0, 1e-9);   // the topmost slice
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
    const core::VesselBranch& trunk = w.current().tree->branches.front();
    const Eigen::Vector3d point = trunk.pointsInPatient[trunk.pointsInPatient.size() / 4];   // far from the fork
    model().setCrosshair(point);
    QApplication::processEvents();

    QTest::mouseMove(&view(BodyPlane::Axial), placeOf(BodyPlane::Axial, point) + QPoint(40, 40));
    QTest::mouseMove(&view(BodyPlane::Axial), placeOf(BodyPlane::Axial, point));
    EXPECT_TRUE(QTest::qWaitFor([&] { return w.controller.branches().marks().hovered == trunk.id; }, 5000));
    click(BodyPlane::Axial, point);
    EXPECT_EQ(w.controller.branches().marks().selected, std::set{trunk.id});

    const core::VesselBranch& other = w.current().tree->branches.back();
    w.controller.branches().select({other.id});   // as the list does
    double nearest = 1e9;
    for (const Eigen::Vector3d& at : other.pointsInPatient) {
        nearest = std::min(nearest, (at - model().crosshair()).norm());
    }
    EXPECT_LT(nearest, 1.0);
}

TEST_F(WindowSlices, ChangeWindowZoomAndPlaceByMouse)
{
    const ui::GreyWindow before = model().window();
    drag(BodyPlane::Axial, Qt::RightButton, {40, 20});
    EXPECT_GT(model().window().width, before.width);
    EXPECT_GT(model().window().level, before.level);

    const QPointF corner(10, 10);
    const Eigen::Vector3d shown = view(BodyPlane::Axial).patientFromWidget(corner);
    drag(BodyPlane::Axial, Qt::MiddleButton, {30, 0});
    const Eigen::Vector3d moved = view(BodyPlane::Axial).patientFromWidget(corner);
    EXPECT_LT(moved.x(), shown.x());
    wheel(BodyPlane::Axial, 3, Qt::ControlModifier);
    EXPECT_GT(view(BodyPlane::Axial).patientFromWidget(corner).x(), moved.x());   // nearer to the middle
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

TEST_F(WindowSlices, TraceWithThresholdAndSeedsAsOneStep)
{
    const auto before = w.current().tree;
    const core::VesselTracingOptions beforeOptions = w.current().vesselInput.tracing;
    press<QCheckBox>(QStringLiteral("Automatic threshold"));
    auto* slider = w.window.tracing().findChild<QSlider*>();
    ASSERT_TRUE(slider->isEnabled());
    slider->setValue(180);
    EXPECT_EQ(model().previewFrom(), 180.0);
    press<QPushButton>(QStringLiteral("Seeds"));
    model().setCrosshair({0, 0, 20});
    QApplication::processEvents();
    click(BodyPlane::Axial, {0, 0, 20});
    EXPECT_EQ(w.window.tracing().findChild<QListWidget*>()->count(), 1);
    EXPECT_TRUE(w.current().vesselInput.tracing == beforeOptions);   // a draft until it has been traced

    press<QPushButton>(QStringLiteral("Trace"));
    ASSERT_TRUE(waitForTrace());

    EXPECT_NE(w.current().tree, before);
    EXPECT_EQ(test::endsOf(*w.current().tree), 3);
    EXPECT_EQ(w.current().vesselInput.tracing.threshold, 180.0);
    ASSERT_EQ(w.current().vesselInput.tracing.seedsInPatient.size(), 1U);
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Trace vessels"));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().tree, before);
    EXPECT_FALSE(w.current().vesselInput.tracing.threshold);
    EXPECT_EQ(w.window.tracing().findChild<QListWidget*>()->count(), 0);
}

TEST_F(WindowSlices, RemoveSeedsFromTheList)
{
    press<QPushButton>(QStringLiteral("Seeds"));
    click(BodyPlane::Axial, model().crosshair());
    press<QPushButton>(QStringLiteral("Avoid"));
    click(BodyPlane::Coronal, model().crosshair() + Eigen::Vector3d(12, 0, 0));
    auto* list = w.window.tracing().findChild<QListWidget*>();
    ASSERT_EQ(list->count(), 2);
    EXPECT_EQ(model().points().at(ui::SliceMarkKind::Avoid).size(), 1U);

    list->setFocus();
    list->setCurrentRow(0);
    const auto tree = w.current().tree;
    QTest::keyClick(list, Qt::Key_Delete);
    EXPECT_EQ(list->count(), 1);
    EXPECT_EQ(w.current().tree, tree);   // the key was the list's, not the branches'
    EXPECT_TRUE(model().points().at(ui::SliceMarkKind::Seed).empty());
}

TEST_F(WindowSlices, StoppingKeepsTheTree)
{
    const auto before = w.current().tree;
    const int steps = w.history().count();
    press<QPushButton>(QStringLiteral("Trace"));
    EXPECT_TRUE(w.controller.tracing().isRunning());
    press<QPushButton>(QStringLiteral("Stop"));
    ASSERT_TRUE(waitForTrace());
    EXPECT_EQ(w.current().tree, before);
    EXPECT_EQ(w.history().count(), steps);
}

TEST_F(WindowSlices, TellWhyNothingCanBeTraced)
{
    press<QCheckBox>(QStringLiteral("Automatic threshold"));
    w.window.tracing().findChild<QSlider*>()->setValue(1100);
    const auto before = w.current().tree;
    press<QPushButton>(QStringLiteral("Trace"));
    ASSERT_TRUE(waitForTrace());
    EXPECT_EQ(w.current().tree, before);
    EXPECT_FALSE(w.window.findChildren<ui::MessageDialog*>().isEmpty());
}

TEST_F(WindowSlices, ShowLabelsOfTheSameScan)
{
    const auto scan = w.current().volume;
    const QString labels = folder.filePath(QStringLiteral("labels.nii.gz"));
    core::LabelVolume image = test::forkLabels();
    std::ranges::replace(image.voxels, std::uint16_t{7}, std::uint16_t{0});
    ASSERT_TRUE(io::writeLabels(image, labels.toStdString()));
    w.drop({labels});
    EXPECT_EQ(w.current().vesselInput.kind, core::VesselInputKind::Segmentation);
    EXPECT_EQ(w.current().volume, scan);
    EXPECT_EQ(w.current().scanFile.path, scanPath.toStdString());
    ASSERT_TRUE(model().lumen());
    EXPECT_NE(model().lumen()->at(32, 18, 26), 0);   // in the trunk
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vesselInput.kind, core::VesselInputKind::Volume);
}

TEST_F(WindowSlices, GoWithTheScan)
{
    const core::RegistrationCase nothing;
    w.controller.document().replace(nothing, {});
    EXPECT_FALSE(model().hasScan());
    EXPECT_FALSE(w.window.slicesPage().isVisible());
    EXPECT_FALSE(w.window.actions()[ui::Command::SlicesLarge]->isEnabled());
}

TEST_F(WindowSlices, ShowTheLandmarksWhileTheseAreClicked)
{
    const Eigen::Vector3d place = w.current().tree->branches.front().pointsInPatient.front();
    w.controller.document().push(std::make_unique<ChangeLandmarks>(
        w.controller.document(), ChangeLandmarks::Values{{core::Landmark{place, {10.0, 20.0}, ""}}},
        QStringLiteral("Click a pair")));
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

/// The same vessels from a file, and then their scan.
class WindowScanBeside : public ::testing::Test {
protected:
    void SetUp() override
    {
        const QString treePath = folder.filePath(QStringLiteral("tree.csv"));
        const QString scanPath = folder.filePath(QStringLiteral("scan.nrrd"));
        core::VesselTree tree;
        tree.branches.push_back({1, "", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {1.0, 1.0, 1.0}, -1});
        const core::Volume scan = test::forkScan();
        for (Eigen::Vector3d& point : tree.branches.front().pointsInPatient) {
            point += scan.geometry.patientFromVoxel() * Eigen::Vector3d(10.0, 10.0, 10.0);
        }
        ASSERT_TRUE(io::writeVesselTree(tree, treePath.toStdString()));
        ASSERT_TRUE(io::writeVolume(scan, scanPath.toStdString()));
        w.drop({treePath});
        ASSERT_TRUE(w.current().tree);
        before = w.current().tree;
        w.drop({scanPath});
        ASSERT_EQ(w.dialogs("scanQuestion").size(), 1);
    }
    void answer(const QString& verb)
    {
        OpenWindow::clickButton(w.dialogs("scanQuestion").front(), verb);
        EXPECT_TRUE(QTest::qWaitFor([this] { return !w.controller.isLoading(); }, test::patienceMs));
        w.window.activateWindow();   // no window manager does it here
        EXPECT_TRUE(QTest::qWaitForWindowActive(&w.window));
    }

    QTemporaryDir folder;
    OpenWindow w;
    std::shared_ptr<const core::VesselTree> before;
};

TEST_F(WindowScanBeside, IsShownInSlicesWithTheVesselsThatAreThere)
{
    answer(QStringLiteral("Show beside the vessels"));
    ASSERT_TRUE(w.current().volume);
    EXPECT_EQ(w.current().tree, before);
    EXPECT_TRUE(w.current().centerlineFile.path.ends_with("tree.csv"));
    EXPECT_TRUE(w.current().scanFile.path.ends_with("scan.nrrd"));
    EXPECT_EQ(w.current().scanFile.sha256.size(), 64U);
    EXPECT_TRUE(w.window.slices().hasScan());
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(w.current().volume);
}

TEST_F(WindowScanBeside, OrItsVesselsAreTraced)
{
    answer(QStringLiteral("Trace its vessels"));
    ASSERT_TRUE(w.current().volume);
    EXPECT_NE(w.current().tree, before);
    EXPECT_TRUE(w.current().centerlineFile.path.ends_with("scan.nrrd"));
}

}   // namespace
}   // namespace app
