#include "tests/app/open_window.h"

#include "tests/support/temporary_folder.h"
#include "ui/theme/active_theme.h"

#include <QCheckBox>
#include <QTreeWidget>

namespace angiopose::app {
namespace {

using test::SampleWindow;

TEST(WindowPoses, KeepsThePoseWithItsNumbersAndUndoesThat)
{
    SampleWindow w;
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    ASSERT_EQ(w.current().shown().snapshots.size(), 1u);   // stored by the registration
    EXPECT_EQ(w.current().shown().snapshots[0].kind, core::SnapshotKind::Run);

    w.press(Qt::Key_K);

    ASSERT_EQ(w.current().shown().snapshots.size(), 2u);
    const core::PoseSnapshot& kept = w.current().shown().snapshots[1];
    EXPECT_EQ(kept.kind, core::SnapshotKind::Saved);
    EXPECT_EQ(kept.method, "angiopose");
    EXPECT_EQ(test::distance(kept.cameraFromPatient, w.current().shown().cameraFromPatient), 0.0);
    ASSERT_TRUE(kept.metrics);
    EXPECT_EQ(kept.metrics->medianMm, w.current().shown().result->metrics.medianMm);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().shown().snapshots.size(), 1u);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(w.current().shown().snapshots.empty());   // the registration and its snapshot are one undo step
    EXPECT_EQ(w.history().index(), 0);
}

TEST(WindowPoses, GoesBetweenTwoPosesWithOneKeyAndChangesNothing)
{
    SampleWindow w;
    w.press(Qt::Key_Y);   // no snapshot to switch to
    EXPECT_FALSE(w.controller.poses().snapshots().marks().shown);
    w.press(Qt::Key_K);
    w.registerVessels();
    const core::RigidTransform found = w.current().shown().cameraFromPatient;
    const int steps = w.history().count();
    const int kept = w.current().shown().snapshots.front().id;
    w.controller.poses().snapshots().mark(kept, false);

    w.press(Qt::Key_Y);
    EXPECT_EQ(w.controller.poses().snapshots().marks().shown, kept);
    w.press(Qt::Key_Y);
    EXPECT_FALSE(w.controller.poses().snapshots().marks().shown);
    w.press(Qt::Key_Y);
    w.press(Qt::Key_Escape);
    EXPECT_FALSE(w.controller.poses().snapshots().marks().shown);
    EXPECT_EQ(w.history().count(), steps);
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, found), 0.0);
}

TEST(WindowPoses, ComparesARunWithTheLastKeptPoseAndNotWithItself)
{
    SampleWindow w;
    w.press(Qt::Key_K);
    const core::PoseSnapshot start = w.current().shown().snapshots.back();
    w.registerVessels();
    ASSERT_GT(test::distance(w.current().shown().cameraFromPatient, start.cameraFromPatient), 1e-3);
    w.press(Qt::Key_Y);
    EXPECT_EQ(w.controller.poses().snapshots().marks().shown, start.id);
    w.press(Qt::Key_Y);

    w.press(Qt::Key_N);
    w.press(Qt::Key_Right, Qt::ShiftModifier);
    w.press(Qt::Key_N);
    w.press(Qt::Key_K);   // the newest snapshot becomes the one to compare with
    const int newest = w.current().shown().snapshots.back().id;
    w.registerVessels();
    w.press(Qt::Key_Y);
    EXPECT_EQ(w.controller.poses().snapshots().marks().shown, newest);
}

TEST(WindowPoses, LeaveNothingToCompareWhereTheOnlyOneIsTheShownPose)
{
    SampleWindow w;
    w.registerVessels();
    ASSERT_EQ(w.current().shown().snapshots.size(), 1u);
    w.press(Qt::Key_Y);
    EXPECT_FALSE(w.controller.poses().snapshots().marks().shown);
}

QTreeWidgetItem* itemNamed(QTreeWidget& list, const QString& name)
{
    const auto items = list.findItems(name, Qt::MatchExactly | Qt::MatchRecursive, 1);
    return items.isEmpty() ? nullptr : items.front();
}

TEST(WindowPoses, RestoresRenamesAndDeletesFromTheList)
{
    SampleWindow w;
    const core::RigidTransform start = w.current().shown().cameraFromPatient;
    w.press(Qt::Key_K);
    w.registerVessels();
    ASSERT_GT(test::distance(w.current().shown().cameraFromPatient, start), 1e-3);
    QTreeWidget& list = *w.window.snapshots().list();
    list.setFocus();

    QTreeWidgetItem* kept = itemNamed(list, QStringLiteral("Pose 1"));
    ASSERT_TRUE(kept);
    list.setCurrentItem(kept);
    QTest::keyClick(&list, Qt::Key_Return);
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, start), 0.0);

    w.window.snapshots().editName(w.current().shown().snapshots.front().id);
    auto* editor = list.viewport()->findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("start of Ada"));
    QTest::keyClick(editor, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return w.current().shown().snapshots.front().name == "start of Ada"; }, 2000));

    kept = itemNamed(list, QStringLiteral("start of Ada"));
    ASSERT_TRUE(kept);
    list.setCurrentItem(kept);
    QTest::keyClick(&list, Qt::Key_Delete);
    EXPECT_EQ(w.current().shown().snapshots.size(), 1u);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().shown().snapshots.size(), 2u);
}

TEST(WindowPoses, RunsSeveralMethodsIntoTheTable)
{
    SampleWindow w;
    const core::RigidTransform before = w.current().shown().cameraFromPatient;
    w.press(Qt::Key_K, Qt::ShiftModifier);
    ui::PoseTable* table = w.controller.poses().table().table();
    ASSERT_TRUE(table);
    for (QCheckBox* box : table->findChildren<QCheckBox*>()) {
        const QByteArray method = box->property("method").toByteArray();
        box->setChecked(method == "angiopose" || method == "dt-icp");
    }
    for (QPushButton* button : table->findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Run")) {
            QTest::mouseClick(button, Qt::LeftButton);
        }
    }
    ASSERT_TRUE(w.controller.poses().table().isRunning());
    ASSERT_TRUE(test::waitFor([&] { return !w.controller.poses().table().isRunning(); }));

    ASSERT_EQ(w.current().shown().snapshots.size(), 2u);
    EXPECT_EQ(w.current().shown().snapshots[0].method, "angiopose");
    EXPECT_EQ(w.current().shown().snapshots[1].method, "dt-icp");
    EXPECT_EQ(table->table()->topLevelItemCount(), 3);   // plus the current pose
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, before), 0.0);
    w.history().undo();
    EXPECT_TRUE(w.current().shown().snapshots.empty());   // both are one undo step
}

TEST(WindowPoses, SurviveSavingAndReopening)
{
    SampleWindow w;
    w.registerVessels();
    w.press(Qt::Key_K);
    const test::TemporaryFolder folder;
    const QString path = QString::fromStdString(folder.file("poses.angiopose"));
    ASSERT_TRUE(w.saveCase(path));

    test::OpenWindow again;
    again.drop({path});
    ASSERT_EQ(again.current().shown().snapshots.size(), 2u);
    EXPECT_EQ(again.current().shown().snapshots[1].name, w.current().shown().snapshots[1].name);
    EXPECT_EQ(test::distance(again.current().shown().snapshots[1].cameraFromPatient,
                             w.current().shown().snapshots[1].cameraFromPatient),
              0.0);
    EXPECT_TRUE(itemNamed(*again.window.snapshots().list(), QStringLiteral("Pose 1")));
}

TEST(WindowPoses, AreWrittenInTheTonesOfTheThemeAfterItChanged)
{
    SampleWindow w;
    w.window.actions()[ui::Command::TakeSnapshot]->trigger();
    QTreeWidget* list = w.window.findChild<ui::SnapshotPanel*>()->list();
    ASSERT_GE(list->topLevelItemCount(), 1);
    const auto ink = [list] { return list->topLevelItem(0)->foreground(1).color(); };
    const ui::ThemeMode before = ui::activeTheme();
    for (const ui::ThemeMode mode : {ui::ThemeMode::Light, ui::ThemeMode::Dark}) {
        ui::applyTheme(*qApp, mode);
        QApplication::processEvents();
        EXPECT_EQ(ink(), ui::toQColor(ui::activePalette().text));
    }
    ui::applyTheme(*qApp, before);
}

}   // namespace
}   // namespace angiopose::app
