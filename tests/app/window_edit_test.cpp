#include "app/files/sample_case.h"
#include "tests/app/open_window.h"
#include "tests/support/matchers.h"
#include "ui/panels/branch_delegate.h"
#include "ui/panels/lock_button.h"

#include <QDir>
#include <QListView>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

/// An image that is no longer in the case but still visible would be mistaken for the image of the case.
TEST(WindowEdit, UndoTakesAnImageFromTheScreenToo)
{
    const auto sample = writeSampleCase();
    ASSERT_TRUE(sample);
    const QDir folder = QFileInfo(sample.value()).dir();
    OpenWindow w;
    w.drop({folder.filePath(QStringLiteral("tree.vtp"))});
    const auto picture = [&w] {
        QApplication::processEvents();
        return w.window.angiogramView().grab().toImage();
    };
    const QImage before = picture();
    w.drop({folder.filePath(QStringLiteral("run.dcm"))});
    ASSERT_TRUE(w.current().shown().angiogram);
    EXPECT_NE(picture(), before);

    w.press(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_FALSE(w.current().shown().angiogram);
    EXPECT_EQ(picture(), before);
}

TEST(WindowEdit, NudgesByKeysAsOneStepOfUndo)
{
    SampleWindow w;
    const core::RigidTransform start = w.current().shown().cameraFromPatient;

    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    w.press(Qt::Key_Right);
    w.press(Qt::Key_Right, Qt::ControlModifier);

    ASSERT_TRUE(w.controller.pose().currentOffset());
    EXPECT_NEAR(w.controller.pose().currentOffset()->rightMm, 2.1, 1e-9);
    EXPECT_EQ(w.history().count(), 1);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, start), 1e-12);
    w.press(Qt::Key_Y, Qt::ControlModifier);
    EXPECT_NEAR(w.controller.pose().currentOffset()->rightMm, 2.1, 1e-9);
}

TEST(WindowEdit, NudgesEveryDegreeOfFreedomByItsKey)
{
    SampleWindow w;
    w.press(Qt::Key_N);
    struct Press {
        Qt::Key key;
        Qt::KeyboardModifiers modifiers;
        ui::PoseAxis axis;
        double amount;
    };
    const std::array presses{Press{Qt::Key_Up, Qt::ShiftModifier, ui::PoseAxis::Up, 10.0},
                             Press{Qt::Key_PageDown, Qt::NoModifier, ui::PoseAxis::AlongRay, -1.0},
                             Press{Qt::Key_Period, Qt::NoModifier, ui::PoseAxis::Roll, 1.0},
                             Press{Qt::Key_Left, Qt::AltModifier, ui::PoseAxis::LaoRao, -1.0},
                             Press{Qt::Key_Up, Qt::AltModifier, ui::PoseAxis::CraCau, 1.0}};
    for (const Press& press : presses) {
        w.press(Qt::Key_Backspace);
        w.press(press.key, press.modifiers);
        EXPECT_NEAR(ui::valueOf(*w.controller.pose().currentOffset(), press.axis), press.amount, 1e-9)
            << ui::labelOf(press.axis).toStdString();
    }
}

TEST(WindowEdit, LeavesArrowsToTheFramesOutsideNudgeMode)
{
    SampleWindow w;
    const core::RigidTransform start = w.current().shown().cameraFromPatient;
    const int frame = w.current().shown().frame;

    w.press(Qt::Key_Down);

    EXPECT_EQ(w.current().shown().frame, frame + 1);
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, start), 1e-12);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().shown().frame, frame);
}

TEST(WindowEdit, KeepsLockedDegreesOfFreedom)
{
    SampleWindow w;
    ui::PoseLocks locks{};
    locks[static_cast<std::size_t>(ui::PoseAxis::Right)] = true;
    w.controller.pose().setLocks(locks);
    EXPECT_EQ(w.history().count(), 1);
    w.press(Qt::Key_N);

    w.press(Qt::Key_Right);
    EXPECT_EQ(w.history().count(), 1);
    w.press(Qt::Key_Up);
    EXPECT_NEAR(w.controller.pose().currentOffset()->upMm, 1.0, 1e-9);
}

TEST(WindowEdit, LocksByItsDotAsOneStepOfUndo)
{
    SampleWindow w;
    auto* dot = w.window.pose().findChildren<ui::LockButton*>()[2];

    QTest::mouseClick(dot, Qt::LeftButton);
    EXPECT_TRUE(core::isLocked(w.current().options.locks, ui::PoseAxis::AlongRay));
    EXPECT_TRUE(dot->isChecked());
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(core::isAnyLocked(w.current().options.locks));
    EXPECT_FALSE(dot->isChecked());
}

class WindowDrag : public ::testing::Test {
protected:
    void SetUp() override
    {
        w.openSample();
        w.press(Qt::Key_N);
        const auto camera = core::cameraOf(w.current().shown());
        const auto pivot = core::project(
            camera.value(), w.current().shown().cameraFromPatient * core::centroidInPatient(*w.current().vessels.tree));
        from = w.window.angiogramView().widgetFromImage(*pivot).toPoint();
        start = w.current().shown().cameraFromPatient;
    }
    void dragTo(const QPoint& to)
    {
        QWidget* view = &w.window.angiogramView();
        QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, from);
        QTest::mouseMove(view, (from + to) / 2);
        QTest::mouseMove(view, to);
        QTest::qWait(50);
    }

    OpenWindow w;
    QPoint from;
    core::RigidTransform start;
};

TEST_F(WindowDrag, MovesTheVesselsWithTheMouse)
{
    dragTo(from + QPoint(40, -30));
    QTest::mouseRelease(&w.window.angiogramView(), Qt::LeftButton, Qt::NoModifier, from + QPoint(40, -30));

    const auto offset = w.controller.pose().currentOffset();
    EXPECT_GT(offset->rightMm, 1.0);
    EXPECT_GT(offset->upMm, 1.0);
    EXPECT_EQ(w.history().count(), 1);
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Move vessels"));
}

TEST_F(WindowDrag, IsTakenBackByEscape)
{
    dragTo(from + QPoint(40, -30));
    EXPECT_GT(w.controller.pose().currentOffset()->rightMm, 1.0);   // the pose panel follows the drag

    w.press(Qt::Key_Escape);
    QTest::mouseRelease(&w.window.angiogramView(), Qt::LeftButton, Qt::NoModifier, from + QPoint(40, -30));

    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, start), 1e-12);
    EXPECT_NEAR(w.controller.pose().currentOffset()->rightMm, 0.0, 1e-9);
    EXPECT_EQ(w.history().count(), 0);
}

TEST(WindowBranches, AreChosenByListAndKey)
{
    SampleWindow w;
    QListView* list = w.window.branches().list();
    const QRect row = list->visualRect(list->model()->index(2, 0));
    const int id = w.current().vessels.tree->branches[2].id;

    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, row.topLeft() + QPoint(40, 8));
    EXPECT_EQ(w.controller.branches().marks().selected, std::set{id});
    QTest::keyClick(list, Qt::Key_A);
    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds, std::vector{id});
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Choose auxiliary branches"));
    QTest::keyClick(list, Qt::Key_X);
    EXPECT_EQ(w.current().vessels.excludedBranchIds, std::vector{id});
    QTest::keyClick(list, Qt::Key_X);
    EXPECT_TRUE(w.current().vessels.excludedBranchIds.empty());
}

TEST(WindowBranches, AreToggledByTheirPill)
{
    SampleWindow w;
    QListView* list = w.window.branches().list();
    const QRect row = list->visualRect(list->model()->index(1, 0));

    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier,
                      ui::BranchDelegate::auxiliaryRect(row).center());

    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds, std::vector{w.current().vessels.tree->branches[1].id});
}

TEST(WindowBranches, ArePickedInTheAngiogram)
{
    SampleWindow w;
    const auto camera = core::cameraOf(w.current().shown());
    ui::AngiogramView& view = w.window.angiogramView();
    for (const core::VesselBranch& branch : w.current().vessels.tree->branches) {
        const auto pixel = core::project(camera.value(), w.current().shown().cameraFromPatient *
                                                             branch.pointsInPatient[branch.pointsInPatient.size() / 2]);
        const QPoint place = pixel ? view.widgetFromImage(*pixel).toPoint() : QPoint(-1, -1);
        if (!view.rect().adjusted(60, 60, -60, -60).contains(place)) {
            continue;
        }
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, place);
        ASSERT_EQ(w.controller.branches().marks().selected.size(), 1U);
        w.press(Qt::Key_A);
        EXPECT_EQ(w.current().vessels.auxiliaryBranchIds.size(), 1U);
        return;
    }
    FAIL() << "no branch of the sample lies in the view";
}

}   // namespace
}   // namespace angiopose::app
