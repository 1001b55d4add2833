#include "tests/app/open_window.h"
#include "ui/places/view_frame.h"
#include "ui/slices/corner_views.h"

namespace angiopose::app {
namespace {

using test::SampleWindow;

ui::ViewWindow* windowOf(QWidget& view)
{
    return qobject_cast<ui::ViewWindow*>(view.window());
}

void waitForWindow(QWidget& view)
{
    ASSERT_TRUE(windowOf(view));
    ASSERT_TRUE(QTest::qWaitForWindowExposed(windowOf(view)));
    QApplication::processEvents();
}

TEST(WindowPlaces, DoubleClickOnTheImageTakesTheWindowAndGivesItBack)
{
    SampleWindow w;
    ui::AngiogramView& view = w.window.angiogramView();
    const QRect before(view.mapTo(&w.window, QPoint()), view.size());
    const QPoint corner(5, 5);
    QTest::mouseDClick(&view, Qt::LeftButton, {}, corner);
    QApplication::processEvents();
    EXPECT_EQ(view.width(), w.window.width());
    EXPECT_TRUE(w.window.actions()[ui::Command::ImageOnly]->isChecked());
    QTest::mouseDClick(&view, Qt::LeftButton, {}, corner);
    QApplication::processEvents();
    EXPECT_EQ(QRect(view.mapTo(&w.window, QPoint()), view.size()), before);
}

TEST(WindowPlaces, TheThreeDViewTakesTheWindowByKeyAndByDoubleClick)
{
    SampleWindow w;
    ui::TreeView& tree = w.window.treeView();
    const QSize before = tree.size();
    const QSize imageBefore = w.window.angiogramView().size();
    w.press(Qt::Key_5);
    QApplication::processEvents();
    EXPECT_EQ(tree.width(), w.window.width());
    EXPECT_FALSE(w.window.angiogramView().isVisible());
    EXPECT_FALSE(w.window.branches().isVisible());

    QTest::mouseDClick(&tree, Qt::LeftButton, {}, {20, 20});
    QApplication::processEvents();
    EXPECT_EQ(tree.size(), before);
    EXPECT_EQ(w.window.angiogramView().size(), imageBefore);
    EXPECT_TRUE(w.window.branches().isVisible());
}

TEST(WindowPlaces, OneViewAloneReplacesTheOther)
{
    SampleWindow w;
    const QSize before = w.window.treeView().size();
    w.press(Qt::Key_5);
    QTest::keyClick(&w.window.treeView(), Qt::Key_4);
    QApplication::processEvents();
    EXPECT_TRUE(w.window.angiogramView().isVisible());
    EXPECT_FALSE(w.window.treeView().isVisible());
    EXPECT_FALSE(w.window.actions()[ui::Command::CornerOnly]->isChecked());
    w.press(Qt::Key_4);
    QApplication::processEvents();
    EXPECT_EQ(w.window.treeView().size(), before);
}

TEST(WindowPlaces, TheThreeDViewLeavesForAWindowAndComesBackWhenItIsClosed)
{
    SampleWindow w;
    ui::TreeView& tree = w.window.treeView();
    const QSize before = tree.size();
    w.press(Qt::Key_F8);
    waitForWindow(tree);
    EXPECT_TRUE(w.window.actions()[ui::Command::CornerWindow]->isChecked());
    EXPECT_TRUE(w.window.branches().isVisible());

    // Keys also work in the separate window, both those of the main window and those of the mode.
    const core::RigidTransform pose = w.current().shown().cameraFromPatient;
    QTest::keyClick(&tree, Qt::Key_N);
    QTest::keyClick(&tree, Qt::Key_Right);
    EXPECT_FALSE(w.current().shown().cameraFromPatient.translation.isApprox(pose.translation, 1e-9));
    EXPECT_TRUE(w.window.actions()[ui::Command::Nudge]->isChecked());
    QTest::keyClick(&tree, Qt::Key_N);

    windowOf(tree)->close();
    QApplication::processEvents();
    EXPECT_EQ(tree.window(), &w.window);
    EXPECT_TRUE(tree.isVisible());
    EXPECT_EQ(tree.size(), before);
    EXPECT_FALSE(w.window.actions()[ui::Command::CornerWindow]->isChecked());
}

TEST(WindowPlaces, TheAngiogramLeavesAPlaceFromWhichItIsBroughtBack)
{
    SampleWindow w;
    ui::AngiogramView& view = w.window.angiogramView();
    w.press(Qt::Key_F7);
    waitForWindow(view);
    EXPECT_TRUE(view.isVisible());
    const QList<QPushButton*> buttons = w.window.frameOf(ui::MovableView::Image).findChildren<QPushButton*>();
    for (QPushButton* button : buttons) {
        if (button->isVisible()) {
            QTest::mouseClick(button, Qt::LeftButton);   // the only button: bring the view back
        }
    }
    QApplication::processEvents();
    EXPECT_EQ(view.window(), &w.window);
    EXPECT_TRUE(view.isVisible());
}

TEST(WindowPlaces, ALayoutRemembersWhatHasAWindowOfItsOwnAndWhere)
{
    QByteArray layout;
    QRect place;
    {
        SampleWindow w;
        w.press(Qt::Key_F8);
        waitForWindow(w.window.treeView());
        windowOf(w.window.treeView())->setGeometry(300, 200, 640, 480);
        QApplication::processEvents();
        place = windowOf(w.window.treeView())->geometry();
        layout = w.window.layoutState();
    }
    test::OpenWindow again;
    again.window.restoreLayout(layout);
    waitForWindow(again.window.treeView());
    EXPECT_EQ(windowOf(again.window.treeView())->geometry().size(), place.size());
    EXPECT_TRUE(again.window.actions()[ui::Command::CornerWindow]->isChecked());

    again.openSample();
    QTest::keyClick(&again.window.treeView(), Qt::Key_F8);
    QApplication::processEvents();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&again.window));
    const QSize beside = again.window.treeView().size();
    again.press(Qt::Key_F8);   // remembers its place when it is detached again
    waitForWindow(again.window.treeView());
    EXPECT_EQ(windowOf(again.window.treeView())->geometry().size(), place.size());
    EXPECT_GT(beside.height(), 100);
}

TEST(WindowPlaces, AnEmptyWindowShowsWhereToStart)
{
    SampleWindow w;
    w.press(Qt::Key_5);
    const core::Case empty;
    w.controller.document().replace(empty, {});
    QApplication::processEvents();
    EXPECT_TRUE(w.window.welcome().isVisible());
    EXPECT_FALSE(w.window.actions()[ui::Command::CornerOnly]->isChecked());
}

}   // namespace
}   // namespace angiopose::app
