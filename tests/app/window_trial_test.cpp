#include "tests/app/open_window.h"

#include "tests/support/temporary_folder.h"

#include <QFile>

namespace angiopose::app {
namespace {

using test::OpenWindow;

ui::BlindTrialSetup setupIn(const test::TemporaryFolder& folder)
{
    return {QStringLiteral("Ada"), 7, 10.0, 5.0, QString::fromStdString(folder.file("trials.csv"))};
}

QByteArrayList linesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().split('\n') : QByteArrayList{};
}

/// Opens the sample and registers it, to have a result that the trial must hide.
void prepare(OpenWindow& w)
{
    w.openSample();
    w.registerVessels();
    w.press(Qt::Key_K);
}

TEST(WindowTrial, HidesWhateverTellsHowGoodThePoseIs)
{
    OpenWindow w;
    prepare(w);
    const core::RigidTransform before = w.current().shown().cameraFromPatient;
    const test::TemporaryFolder folder;

    w.controller.poses().blindTrial().start(setupIn(folder));
    QTest::qWait(400);   // an assessment in progress would have arrived by now

    EXPECT_GT(test::distance(w.current().shown().cameraFromPatient, before), 0.1);
    EXPECT_FALSE(w.controller.evaluation());
    EXPECT_FALSE(w.current().shown().result);
    EXPECT_TRUE(w.current().shown().snapshots.empty());
    EXPECT_FALSE(w.window.result().isVisible());
    EXPECT_FALSE(w.window.snapshots().isVisible());
    EXPECT_TRUE(w.window.trialBar().isVisible());
    w.press(Qt::Key_Left);   // keys nudge immediately
    QTest::qWait(300);
    EXPECT_FALSE(w.controller.evaluation());
    for (const Qt::Key key : {Qt::Key_R, Qt::Key_W, Qt::Key_J, Qt::Key_P, Qt::Key_U, Qt::Key_K, Qt::Key_Y}) {
        w.press(key);
    }
    EXPECT_FALSE(w.controller.registration().isRunning());
    EXPECT_FALSE(w.window.registration().registerButton()->isEnabled());
    EXPECT_TRUE(w.current().shown().snapshots.empty());
    for (int i = 0; i < 5; ++i) {   // undo stops at the start of the trial
        w.press(Qt::Key_Z, Qt::ControlModifier);
    }
    EXPECT_TRUE(w.controller.poses().blindTrial().isRunning());
    EXPECT_GT(test::distance(w.current().shown().cameraFromPatient, before), 0.1);
}

TEST(WindowTrial, LogsTheTrialAndGivesTheCaseBack)
{
    OpenWindow w;
    prepare(w);
    const core::RigidTransform before = w.current().shown().cameraFromPatient;
    const core::RigidTransform start = core::initialPoseOf(w.current()).value();
    const std::size_t known = w.current().shown().snapshots.size();
    const int step = w.history().index();
    const test::TemporaryFolder folder;
    const ui::BlindTrialSetup setup = setupIn(folder);
    w.controller.poses().blindTrial().start(setup);
    w.press(Qt::Key_Left);   // keys nudge immediately
    w.press(Qt::Key_Up);
    const core::RigidTransform final = w.current().shown().cameraFromPatient;

    w.press(Qt::Key_Return, Qt::ControlModifier);

    EXPECT_FALSE(w.controller.poses().blindTrial().isRunning());
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, before), 0.0);
    EXPECT_EQ(test::distance(core::initialPoseOf(w.current()).value(), start), 0.0);
    EXPECT_TRUE(w.current().shown().result);
    ASSERT_TRUE(test::waitFor([&] { return w.current().shown().snapshots.size() == known + 1; }));
    const core::PoseSnapshot& observed = w.current().shown().snapshots.back();
    EXPECT_EQ(observed.author, "Ada");
    EXPECT_TRUE(observed.metrics);
    EXPECT_EQ(test::distance(observed.cameraFromPatient, final), 0.0);
    EXPECT_EQ(w.history().index(), step + 1);
    EXPECT_FALSE(w.history().canRedo());
    ASSERT_TRUE(test::waitFor([&] { return linesOf(setup.logPath).size() == 2; }));
    EXPECT_TRUE(linesOf(setup.logPath)[1].contains(",Ada,"));
    EXPECT_TRUE(linesOf(setup.logPath)[1].contains(",2,done,"));   // two edits
    EXPECT_TRUE(w.window.result().isVisible());
}

TEST(WindowTrial, StartsAlikeForTheSameSeedAndLeavesNothingWhenAbandoned)
{
    OpenWindow w;
    prepare(w);
    const core::RigidTransform before = w.current().shown().cameraFromPatient;
    const std::size_t known = w.current().shown().snapshots.size();
    const test::TemporaryFolder folder;
    w.controller.poses().blindTrial().start(setupIn(folder));
    const core::RigidTransform first = w.current().shown().cameraFromPatient;
    w.controller.poses().blindTrial().abandon();
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, before), 0.0);
    EXPECT_FALSE(w.history().canRedo());
    w.controller.poses().blindTrial().start(setupIn(folder));
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, first), 0.0);
    w.controller.poses().blindTrial().abandon();
    EXPECT_EQ(w.current().shown().snapshots.size(), known);
    ASSERT_TRUE(test::waitFor([&] { return linesOf(setupIn(folder).logPath).size() == 3; }));
    EXPECT_TRUE(linesOf(setupIn(folder).logPath)[2].contains(",abandoned,"));
}

TEST(WindowTrial, CannotBeSavedNorReplacedUnderWay)
{
    OpenWindow w;
    prepare(w);
    const test::TemporaryFolder folder;
    w.controller.poses().blindTrial().start(setupIn(folder));
    const QString path = QString::fromStdString(folder.file("leak.angiopose"));
    w.controller.saveController().saveTo(path);
    QTest::qWait(100);
    EXPECT_FALSE(QFile::exists(path));
    w.controller.poses().blindTrial().abandon();
}

}   // namespace
}   // namespace angiopose::app
