#include "io/angiogram_file.h"
#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"
#include "ui/panels/play_bar.h"
#include "ui/plots/frame_bars.h"

#include <QComboBox>
#include <QThread>
#include <QToolButton>

#include <cmath>

namespace angiopose::app {
namespace {

using test::OpenWindow;

constexpr int cineFrames = 10;
constexpr double cineFrameMs = 40.0;

/// Frames that encode their number in the gray value of their first row.
core::Angiogram numberedRun(int count)
{
    core::Angiogram run;
    for (int k = 0; k < count; ++k) {
        core::ImageF frame(64, 48);
        for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
            frame.pixels[i] = i < 64 ? static_cast<float>(100 * k) : static_cast<float>(500 + (i * 7) % 400);
        }
        run.frames.push_back(std::move(frame));
    }
    run.frameTimeMs = cineFrameMs;
    run.rWaveFrames = {2, 7};
    return run;
}

class WindowCine : public ::testing::Test {
protected:
    void SetUp() override
    {
        settings::playSpeed.write(1.0);
        settings::playBackAndForth.write(false);
        w = std::make_unique<OpenWindow>();
        openRun(cineFrames);
        ASSERT_TRUE(test::waitFor([this] { return bars().cursor().shape() == Qt::PointingHandCursor; }));
    }
    void openRun(int count)
    {
        const std::string path = folder.file("run" + std::to_string(count) + ".dcm");
        ASSERT_TRUE(io::writeAngiogram(numberedRun(count), path));
        w->drop({QString::fromStdString(path)});
        ASSERT_TRUE(w->current().shown().angiogram);
    }

    ui::FrameBars& bars() { return *w->window.findChild<ui::FrameBars*>(); }
    ui::PlayBar& bar() { return w->window.strip().play(); }
    QToolButton& playButton() { return *bar().findChild<QToolButton*>(QStringLiteral("playButton")); }
    QComboBox& speeds() { return *bar().findChild<QComboBox*>(); }
    bool isPlaying() { return w->window.actions()[ui::Command::Cine]->isChecked(); }
    int onScreen()
    {
        return static_cast<int>(std::lround(w->window.angiogramView().scene().frame().pixels[0] / 100.0F));
    }
    int chosen() { return w->current().shown().frame; }

    /// The sequence of frames shown on the screen.
    std::vector<int> seenFor(int ms)
    {
        std::vector<int> frames{onScreen()};
        QElapsedTimer time;
        time.start();
        while (time.elapsed() < ms) {
            QTest::qWait(2);
            if (const int frame = onScreen(); frame != frames.back()) {
                frames.push_back(frame);
            }
        }
        return frames;
    }
    QPoint grip(bool isLast) { return {isLast ? bars().width() - 4 : 3, 4}; }
    int middleOf(int frame) { return (2 * frame + 1) * bars().width() / (2 * cineFrames); }
    void dragGrip(bool isLast, int frame)
    {
        QTest::mousePress(&bars(), Qt::LeftButton, {}, grip(isLast));
        QTest::mouseMove(&bars(), {middleOf(frame), 4});
        QTest::mouseRelease(&bars(), Qt::LeftButton, {}, {middleOf(frame), 4});
    }

    const test::TemporaryFolder folder;
    std::unique_ptr<OpenWindow> w;
};

TEST_F(WindowCine, PlayingLeavesTheCaseAsItIs)
{
    const int before = chosen();
    const bool wasModified = w->controller.document().isModified();
    const int steps = w->history().count();
    ASSERT_TRUE(playButton().isVisible());
    QTest::mouseClick(&playButton(), Qt::LeftButton);
    ASSERT_TRUE(isPlaying());
    EXPECT_GT(seenFor(800).size(), 5U);
    EXPECT_EQ(chosen(), before);
    EXPECT_EQ(w->history().count(), steps);
    EXPECT_EQ(w->controller.document().isModified(), wasModified);

    w->press(Qt::Key_Escape);
    EXPECT_FALSE(isPlaying());
    EXPECT_EQ(onScreen(), before);
    EXPECT_EQ(w->history().count(), steps);
}

TEST_F(WindowCine, PauseKeepsTheFrameInOneStep)
{
    const int before = chosen();
    const int steps = w->history().index();
    w->press(Qt::Key_C);
    ASSERT_TRUE(test::waitFor([&] { return onScreen() == (before + 3) % cineFrames; }));
    QTest::mouseClick(&playButton(), Qt::LeftButton);
    EXPECT_FALSE(isPlaying());
    const int kept = onScreen();
    EXPECT_NE(kept, before);
    EXPECT_EQ(chosen(), kept);
    EXPECT_EQ(w->history().index(), steps + 1);
    QTest::qWait(150);
    EXPECT_EQ(onScreen(), kept) << "it stands";
    w->window.actions()[ui::Command::Undo]->trigger();
    EXPECT_EQ(chosen(), before);
    EXPECT_EQ(onScreen(), before);
}

TEST_F(WindowCine, FramesAreLeftOutRatherThanLate)
{
    w->press(Qt::Key_Comma, Qt::ControlModifier);
    w->press(Qt::Key_Comma, Qt::ControlModifier);   // quarter speed: 160 ms per frame
    const int from = onScreen();
    QElapsedTimer time;
    time.start();
    w->press(Qt::Key_C);
    QThread::msleep(900);   // something else blocks the window
    const auto isDue = [&] {
        const int due = static_cast<int>(static_cast<double>(time.elapsed()) / (4.0 * cineFrameMs));
        return onScreen() == (from + due) % cineFrames;
    };
    EXPECT_TRUE(QTest::qWaitFor(isDue, 300)) << "on screen " << onScreen() << " from " << from;
}

TEST_F(WindowCine, TheEndsOfTheLaneAreTheLoop)
{
    dragGrip(false, 3);
    dragGrip(true, 5);
    w->press(Qt::Key_C);
    ASSERT_TRUE(test::waitFor([this] { return onScreen() == 3; }));
    for (const int frame : seenFor(600)) {
        EXPECT_TRUE(frame >= 3 && frame <= 5) << frame;
    }
    QTest::mouseDClick(&bars(), Qt::LeftButton, {}, {middleOf(8), 4});
    EXPECT_TRUE(test::waitFor([this] { return onScreen() == 8; })) << "the whole run again";
}

TEST_F(WindowCine, KeysSetTheLoopAtTheFrameShown)
{
    w->press(Qt::Key_Home);
    w->press(Qt::Key_Down);
    w->press(Qt::Key_BracketLeft, Qt::ControlModifier);
    w->press(Qt::Key_Down);
    w->press(Qt::Key_BracketRight, Qt::ControlModifier);
    w->press(Qt::Key_C);
    for (const int frame : seenFor(400)) {
        EXPECT_TRUE(frame == 1 || frame == 2) << frame;
    }
}

TEST_F(WindowCine, AFrameAloneCanBePulledWideAgain)
{
    dragGrip(false, 9);
    const QPoint place{bars().width() - 4, 4};
    QTest::mousePress(&bars(), Qt::LeftButton, {}, place);
    QTest::mouseMove(&bars(), {middleOf(6), 4});
    QTest::mouseRelease(&bars(), Qt::LeftButton, {}, {middleOf(6), 4});
    w->press(Qt::Key_C);
    EXPECT_TRUE(test::waitFor([this] { return onScreen() == 7; }));
}

TEST_F(WindowCine, GoesBackAndForthAndRemembersHow)
{
    QTest::mouseClick(bar().findChild<QToolButton*>(QStringLiteral("playOrder")), Qt::LeftButton);
    w->press(Qt::Key_Period, Qt::ControlModifier);
    EXPECT_EQ(speeds().currentIndex(), 3);
    EXPECT_TRUE(settings::playBackAndForth.read());
    EXPECT_EQ(settings::playSpeed.read(), 2.0);
    w->press(Qt::Key_End);
    w->press(Qt::Key_C);
    bool goesDown = false;   // frame by frame, not directly to the first; a busy machine skips frames
    for (int look = 0; look < 20 && !goesDown; ++look) {
        const std::vector<int> seen = seenFor(200);
        const auto isStepDown = [](int before, int after) { return before > after && before - after <= 3; };
        int steps = 0;
        for (std::size_t i = 1; i < seen.size(); ++i) {
            steps += isStepDown(seen[i - 1], seen[i]) ? 1 : 0;
        }
        goesDown = steps >= 2;
    }
    EXPECT_TRUE(goesDown) << "down again from the last";

    w = std::make_unique<OpenWindow>();
    openRun(4);
    EXPECT_EQ(speeds().currentIndex(), 3);
    EXPECT_TRUE(w->window.actions()[ui::Command::PlayBackAndForth]->isChecked());
}

TEST_F(WindowCine, SaysHowFastTheRunWasTaken)
{
    EXPECT_EQ(speeds().itemText(2), QStringLiteral("1× · 25 fps"));
    EXPECT_EQ(speeds().itemText(1), QStringLiteral("½× · 12.5 fps"));
    QTest::mouseMove(&bars(), {middleOf(7), bars().height() / 2});
    EXPECT_TRUE(bars().toolTip().contains(QStringLiteral("R wave"))) << bars().toolTip().toStdString();
}

TEST_F(WindowCine, OneFrameHasNothingToPlay)
{
    w = std::make_unique<OpenWindow>();
    openRun(1);
    EXPECT_FALSE(bar().isVisible());
    EXPECT_FALSE(w->window.actions()[ui::Command::Cine]->isEnabled());
    w->press(Qt::Key_C);
    EXPECT_FALSE(isPlaying());
}

}   // namespace
}   // namespace angiopose::app
