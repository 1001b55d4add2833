#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"
#include "ui/plots/frame_bars.h"
#include "ui/plots/opacification_plot.h"

#include <QComboBox>
#include <QWheelEvent>

namespace angiopose::app {
namespace {

class WindowSubtraction : public ::testing::Test {
protected:
    void SetUp() override
    {
        w.openSample();
        ASSERT_GT(w.current().shown().angiogram->frameCount(), 3);
        stored = w.current().shown().angiogram;
        w.window.angiogramPanel().setFolded(false);
        // The strip accepts clicks once the run has been measured.
        ASSERT_TRUE(test::waitFor([this] { return bars().cursor().shape() == Qt::PointingHandCursor; }));
    }

    bool waitForRun()
    {
        return test::waitFor([this] { return !w.controller.angiogram().subtraction().isComputing(); });
    }
    ui::FrameBars& bars() { return *w.window.findChild<ui::FrameBars*>(); }
    QPoint onBar(int frame)
    {
        const int count = stored->frameCount();
        return {(2 * frame + 1) * bars().width() / (2 * count), bars().height() / 2};
    }
    const core::ImageF& shownPicture() { return w.window.angiogramView().scene().frame(); }
    const core::ImageF& pictureOf(const core::Angiogram& run)
    {
        return run.frames[static_cast<std::size_t>(w.current().shown().frame)];
    }
    void markFirstFrames()
    {
        QTest::mousePress(&bars(), Qt::LeftButton, Qt::ShiftModifier, onBar(0));
        QTest::mouseMove(&bars(), onBar(1));
        QTest::mouseRelease(&bars(), Qt::LeftButton, Qt::ShiftModifier, onBar(1));
        ASSERT_TRUE(waitForRun());
    }

    test::OpenWindow w;
    std::shared_ptr<const core::Angiogram> stored;
};

TEST_F(WindowSubtraction, MasksMarkedInTheStripAreSubtracted)
{
    const int frame = w.current().shown().frame;
    markFirstFrames();

    EXPECT_TRUE(w.current().shown().processing.isSubtracted);
    EXPECT_EQ(w.current().shown().processing.plan.maskFrames, (std::vector<int>{0, 1}));
    EXPECT_EQ(w.current().shown().storedRun, stored);
    EXPECT_EQ(w.current().shown().frame, frame);
    const auto expected = core::subtractRun(stored->frames, stored->polarity, w.current().shown().processing.plan);
    ASSERT_TRUE(expected) << expected.error().message;
    EXPECT_EQ(shownPicture().pixels, expected.value().frames[static_cast<std::size_t>(frame)].pixels);
    EXPECT_EQ(w.history().count(), 1) << "one step";
}

TEST_F(WindowSubtraction, OneKeySwitchesToAndFro)
{
    markFirstFrames();
    const auto subtracted = w.current().shown().angiogram;
    w.press(Qt::Key_B);
    ASSERT_TRUE(waitForRun());
    EXPECT_EQ(w.current().shown().angiogram, stored);
    EXPECT_EQ(shownPicture().pixels, pictureOf(*stored).pixels);
    w.press(Qt::Key_B);
    EXPECT_FALSE(w.controller.angiogram().subtraction().isComputing()) << "remembered";
    EXPECT_EQ(w.current().shown().angiogram, subtracted);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(w.current().shown().processing.isSubtracted);
    EXPECT_EQ(w.current().shown().angiogram, stored);
}

TEST_F(WindowSubtraction, TheShownPictureIsTheOneTraced)
{
    markFirstFrames();
    ASSERT_TRUE(test::waitFor([this] { return w.controller.target().current() || w.controller.target().problem(); }));
    const auto expected = core::targetOf(w.current().shown());
    ASSERT_EQ(expected ? true : false, w.controller.target().current() != nullptr);
    if (expected) {
        EXPECT_EQ(w.controller.target().current()->pointCount(), expected.value().pointCount());
    }
}

TEST_F(WindowSubtraction, ArrowsMoveTheMaskAndRestingTakesIt)
{
    markFirstFrames();
    const auto steps = w.history().count();
    w.press(Qt::Key_B, Qt::ShiftModifier);
    EXPECT_TRUE(w.window.actions()[ui::Command::ShiftMask]->isChecked());
    ASSERT_TRUE(test::waitFor([this] { return !w.controller.angiogram().subtraction().isFindingShift(); }));
    const core::RigidTransform pose = w.current().shown().cameraFromPatient;
    w.press(Qt::Key_Right);
    w.press(Qt::Key_Right);
    w.press(Qt::Key_Down, Qt::ShiftModifier);
    ASSERT_TRUE(test::waitFor([this] { return w.current().shown().processing.plan.maskShiftPx.has_value(); }));
    EXPECT_EQ(w.history().count(), steps + 1) << "a burst of keys is one step";
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, pose), 1e-12) << "the arrows were not nudges";
    core::SubtractionPlan byItself = w.current().shown().processing.plan;
    byItself.maskShiftPx.reset();
    const auto automatic = core::subtractFrame(stored->frames, stored->polarity, byItself, w.current().shown().frame);
    ASSERT_TRUE(automatic);
    const Eigen::Vector2d moved = *w.current().shown().processing.plan.maskShiftPx - automatic.value().maskShiftPx;
    EXPECT_NEAR(moved.x(), 0.5, 1e-9);
    EXPECT_NEAR(moved.y(), 1.0, 1e-9);
    w.press(Qt::Key_Escape);
    EXPECT_EQ(w.window.angiogramView().tool(), nullptr);
}

TEST_F(WindowSubtraction, TheCompositeIsInEveryFrame)
{
    w.press(Qt::Key_C, Qt::ShiftModifier);
    ASSERT_TRUE(waitForRun());
    EXPECT_TRUE(w.current().shown().processing.isComposite);
    const auto whole = core::peakOpacificationImage(stored->frames, stored->polarity);
    EXPECT_EQ(shownPicture().pixels, whole.pixels);
    w.press(Qt::Key_Home);
    EXPECT_EQ(shownPicture().pixels, whole.pixels);
}

TEST_F(WindowSubtraction, PolarityIsCorrectedAsAStep)
{
    auto* panel = &w.window.angiogramPanel();
    for (QComboBox* box : panel->findChildren<QComboBox*>()) {
        if (box->accessibleName() == QStringLiteral("Vessels")) {
            box->setFocus();
            QTest::keyClick(box, Qt::Key_Down);
        }
    }
    ASSERT_TRUE(waitForRun());
    EXPECT_EQ(w.current().shown().angiogram->polarity, core::Polarity::VesselsBright);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().shown().angiogram->polarity, core::Polarity::VesselsDark);
}

TEST_F(WindowSubtraction, ScrollingPastAChoiceDoesNotChangeIt)
{
    for (QComboBox* box : w.window.angiogramPanel().findChildren<QComboBox*>()) {
        const QPointF middle = QRectF(box->rect()).center();
        QWheelEvent wheel(middle, box->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(box, &wheel);
    }
    EXPECT_TRUE(waitForRun());
    EXPECT_EQ(w.history().count(), 0);
}

TEST_F(WindowSubtraction, SurvivesSavingAndReopening)
{
    markFirstFrames();
    const test::TemporaryFolder folder;
    const std::string path = folder.file("case.angiopose");
    ASSERT_TRUE(w.saveCase(QString::fromStdString(path)));
    const auto picture = shownPicture().pixels;
    w.drop({QString::fromStdString(path)});
    EXPECT_TRUE(w.current().shown().processing.isSubtracted);
    EXPECT_EQ(shownPicture().pixels, picture);
    EXPECT_TRUE(w.window.actions()[ui::Command::Subtract]->isChecked());
}

TEST_F(WindowSubtraction, TracingFollowsItsNumbers)
{
    ASSERT_TRUE(test::waitFor([this] { return w.controller.target().current() != nullptr; }));
    const auto before = w.controller.target().current();
    ui::NumberField* sensitivity = nullptr;
    for (auto* field : w.window.angiogramPanel().findChildren<ui::NumberField*>()) {
        sensitivity = field->accessibleName() == QStringLiteral("sensitivity") ? field : sensitivity;
    }
    ASSERT_TRUE(sensitivity);
    sensitivity->setFocus();
    sensitivity->selectAll();
    QTest::keyClicks(sensitivity, QStringLiteral("2.5"));
    QTest::keyClick(sensitivity, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(w.current().shown().traceOptions.sensitivity, 2.5);
    ASSERT_TRUE(
        test::waitFor([&] { return w.controller.target().current() && w.controller.target().current() != before; }));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.controller.target().current(), before) << "remembered";
}

TEST_F(WindowSubtraction, ThePlotShowsFramesAndChoosesThem)
{
    w.press(Qt::Key_G);
    const auto open = w.dialogs("opacificationDialog");
    ASSERT_EQ(open.size(), 1);
    auto* plot = open.front()->findChild<ui::OpacificationPlot*>();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(open.front()));
    ASSERT_TRUE(QTest::qWaitFor(
        [this, plot] { return plot->pointOf(0).x() < plot->pointOf(stored->frameCount() - 1).x(); }, 5000));
    QTest::mouseMove(plot, plot->pointOf(2).toPoint());
    EXPECT_TRUE(QTest::qWaitFor([plot] { return plot->hoveredFrame() == 2; }, 5000));
    QTest::mouseClick(plot, Qt::LeftButton, {}, plot->pointOf(2).toPoint());
    EXPECT_EQ(w.current().shown().frame, 2);
    open.front()->close();
}

TEST_F(WindowSubtraction, ARunThatIsLeftWhileItIsSubtractedIsLetGo)
{
    w.press(Qt::Key_B);
    ASSERT_TRUE(w.controller.angiogram().subtraction().isComputing());
    const std::weak_ptr<const core::Angiogram> run = std::exchange(stored, nullptr);
    w.controller.document().replace({}, {});
    EXPECT_TRUE(test::waitFor([&] { return run.expired(); })) << run.use_count();
    EXPECT_FALSE(w.controller.angiogram().subtraction().isComputing());
}

}   // namespace
}   // namespace angiopose::app
