#include "ui/views/image_tool.h"

#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"

#include <gtest/gtest.h>
#include <QAction>
#include <QKeyEvent>
#include <QSignalSpy>
#include <QTest>

using namespace angiopose;

namespace {

class RecordingTool : public ui::ImageTool {
public:
    using ImageTool::ImageTool;

    QString caption() const override { return QStringLiteral("Recording"); }
    void begin() override { log << QStringLiteral("begin"); }
    void end() override { log << QStringLiteral("end"); }
    bool startDrag(const ui::ToolPoint&) override
    {
        log << QStringLiteral("start");
        return takesDrags;
    }
    void finishDrag(const ui::ToolPoint&) override { log << QStringLiteral("finish"); }
    void cancelDrag() override { log << QStringLiteral("cancel"); }
    bool click(const ui::ToolPoint& point) override
    {
        clicked = point.imagePx;
        return true;
    }
    bool takesKey(const QKeyEvent& event) const override { return event.key() == Qt::Key_Return; }
    void keyPress(const QKeyEvent&) override { log << QStringLiteral("key"); }
    bool undoStep() override { return std::exchange(hasStep, false); }

    QStringList log;
    bool takesDrags = true;
    bool hasStep = false;
    Eigen::Vector2d clicked = Eigen::Vector2d::Zero();
};

class ImageToolTest : public ::testing::Test {
protected:
    ImageToolTest()
    {
        view.resize(640, 480);
        view.setFrame(core::ImageF(512, 512, 0.0F));
        view.setWindowLevel(1.0, 0.5);
        view.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
        view.setTool(tool);
    }
    void press(const QPoint& at) { QTest::mousePress(&view, Qt::LeftButton, {}, at); }
    void moveOn()
    {
        QTest::mouseMove(&view, {300, 200});
        QTest::mouseMove(&view, {320, 210});
    }

    ui::AngiogramView view;
    RecordingTool* tool = new RecordingTool(view);
};

TEST_F(ImageToolTest, TakesTheLeftDragFromWindowAndLevel)
{
    press({280, 200});
    moveOn();
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {320, 210});
    EXPECT_EQ(tool->log, QStringList({"begin", "start", "finish"}));
    EXPECT_DOUBLE_EQ(view.shownRange().window(), 1.0);
}

TEST_F(ImageToolTest, LeavesToTheViewWhatItDoesNotTake)
{
    tool->takesDrags = false;
    press({280, 200});
    moveOn();
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {320, 210});
    EXPECT_EQ(tool->log, QStringList({"begin", "start"}));
    EXPECT_NE(view.shownRange().window(), 1.0);
}

TEST_F(ImageToolTest, GetsClicksInImagePixels)
{
    QSignalSpy background(&view, &ui::AngiogramView::backgroundClicked);
    QTest::mouseClick(&view, Qt::LeftButton, {}, {200, 100});
    EXPECT_LT((tool->clicked - view.imageFromWidget({200, 100})).norm(), 1e-9);
    EXPECT_EQ(background.size(), 0);
}

TEST_F(ImageToolTest, EscapeTakesBackDragThenStepThenMode)
{
    tool->hasStep = true;
    press({280, 200});
    moveOn();
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(tool->log.last(), QStringLiteral("cancel"));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {320, 210});
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(tool->hasStep);
    EXPECT_EQ(view.tool(), tool);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(view.tool(), nullptr);
    EXPECT_EQ(tool->log, QStringList({"begin", "start", "cancel", "end"}));
}

TEST_F(ImageToolTest, KeysComeBeforeShortcuts)
{
    QAction shortcut;
    shortcut.setShortcut(Qt::Key_Return);
    view.addAction(&shortcut);
    QSignalSpy triggered(&shortcut, &QAction::triggered);
    QTest::keyClick(&view, Qt::Key_Return);
    EXPECT_EQ(tool->log.last(), QStringLiteral("key"));
    EXPECT_EQ(triggered.size(), 0);
}

TEST_F(ImageToolTest, OneModeEndsTheOther)
{
    QAction first;
    QAction second;
    for (QAction* action : {&first, &second}) {
        action->setCheckable(true);
        ui::bindTool(*action, view, action == &first ? *tool : *new RecordingTool(view));
    }
    first.setChecked(true);
    second.setChecked(true);
    EXPECT_FALSE(first.isChecked());
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(second.isChecked());
    EXPECT_EQ(view.tool(), nullptr);
}

}   // namespace
