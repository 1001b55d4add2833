#include "tests/app/open_window.h"

#include "app/document/edit_case.h"

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

void makeRunLong(OpenWindow& w)
{
    core::RegistrationOptions options = w.current().options;
    options.method = "iterative-pnp";
    options.maxIterations = 1000;
    w.controller.document().push(std::make_unique<ChangeOptions>(
        w.controller.document(), ChangeOptions::Values{options}, [] { return QStringLiteral("Change"); }));
}

TEST(WindowRun, RegistersByKeyAsOneStepOfUndo)
{
    SampleWindow w;
    const core::RigidTransform start = w.current().shown().cameraFromPatient;

    w.press(Qt::Key_R);
    EXPECT_TRUE(w.controller.registration().isRunning());
    w.waitForRun();

    ASSERT_TRUE(w.current().shown().result);
    EXPECT_LT(w.current().shown().result->metrics.medianPx, 2.0);
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Register (AngioPose)"));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, start), 1e-12);
    EXPECT_FALSE(w.current().shown().result);
}

TEST(WindowRun, KeepsWhatIsLocked)
{
    SampleWindow w;
    w.press(Qt::Key_N);
    w.press(Qt::Key_PageUp);
    w.press(Qt::Key_Left, Qt::AltModifier);
    w.press(Qt::Key_N);
    const core::PoseOffset before = *w.controller.pose().currentOffset();
    ui::PoseLocks locks{};
    locks[static_cast<std::size_t>(ui::PoseAxis::AlongRay)] = true;
    locks[static_cast<std::size_t>(ui::PoseAxis::LaoRao)] = true;
    w.controller.pose().setLocks(locks);

    w.registerVessels();

    ASSERT_TRUE(w.current().shown().result);
    const core::PoseOffset after = *w.controller.pose().currentOffset();
    EXPECT_NEAR(after.alongRayMm, before.alongRayMm, 1e-9);
    EXPECT_NEAR(after.laoRaoDeg, before.laoRaoDeg, 1e-9);
    EXPECT_GT(std::abs(after.craCauDeg - before.craCauDeg), 1e-3);
}

TEST(WindowRun, StopsAndKeepsAPoseThatCanBeUndone)
{
    SampleWindow w;
    makeRunLong(w);
    const int steps = w.history().count();
    w.press(Qt::Key_R);
    ASSERT_TRUE(w.controller.registration().isRunning());

    w.press(Qt::Key_R, Qt::ShiftModifier);
    w.waitForRun();

    EXPECT_LE(w.history().count(), steps + 1);
    EXPECT_TRUE(core::isRigid(w.current().shown().cameraFromPatient));
    EXPECT_TRUE(w.window.registration().registerButton()->isEnabled());
    w.waitForJudgement();
}

TEST(WindowRun, RefusesEditsMeanwhile)
{
    SampleWindow w;
    makeRunLong(w);
    const int frame = w.current().shown().frame;
    w.press(Qt::Key_R);
    ASSERT_TRUE(w.controller.registration().isRunning());

    w.press(Qt::Key_Down);
    w.press(Qt::Key_Z, Qt::ControlModifier);

    EXPECT_EQ(w.current().shown().frame, frame);
    EXPECT_EQ(w.current().options.maxIterations, 1000);
    w.controller.registration().stop();
    w.waitForRun();
}

TEST(WindowRun, AsksOnceWhenClosedAndStopsSafely)
{
    SampleWindow w;
    makeRunLong(w);
    w.press(Qt::Key_R);
    ASSERT_TRUE(w.controller.registration().isRunning());

    w.window.close();
    w.window.close();
    ASSERT_EQ(w.dialogs("closeQuestion").size(), 1);
    EXPECT_TRUE(w.window.isVisible());
    OpenWindow::clickButton(w.dialogs("closeQuestion").front(), QStringLiteral("Stop and close"));

    EXPECT_TRUE(test::waitFor([&w] { return !w.window.isVisible(); }));
    EXPECT_FALSE(w.controller.registration().isRunning());
    EXPECT_TRUE(w.dialogs("closeQuestion").isEmpty());
}

TEST(WindowRun, SaysWhatIsMissingInsteadOfRunning)
{
    OpenWindow w;

    w.press(Qt::Key_R);

    ASSERT_EQ(w.dialogs("messageDialog").size(), 1);
    EXPECT_FALSE(w.controller.registration().isRunning());
}

TEST(WindowRun, SurvivesDestructionWhileRunning)
{
    auto w = std::make_unique<OpenWindow>();
    w->openSample();
    makeRunLong(*w);
    w->press(Qt::Key_R);
    EXPECT_TRUE(w->controller.registration().isRunning());

    w.reset();
    QCoreApplication::processEvents();
}

}   // namespace
}   // namespace angiopose::app
