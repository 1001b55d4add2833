#include "io/case/case_file.h"
#include "tests/app/open_window.h"
#include "tests/app/scan_window.h"
#include "tests/support/temporary_folder.h"
#include "ui/places/folding_column.h"
#include "ui/slices/corner_views.h"

#include <QSettings>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

TEST(WindowLayout, ShowsTheImageAloneAndTheColumnsAgain)
{
    SampleWindow w;
    const int before = w.window.angiogramView().width();
    w.press(Qt::Key_4);
    QApplication::processEvents();
    EXPECT_FALSE(w.window.branches().isVisible());
    EXPECT_FALSE(w.window.result().isVisible());
    EXPECT_GT(w.window.angiogramView().width(), before + 300);
    w.press(Qt::Key_4);
    QApplication::processEvents();
    EXPECT_TRUE(w.window.branches().isVisible());
    EXPECT_EQ(w.window.angiogramView().width(), before);
}

ui::Section* sectionNamed(ui::MainWindow& window, const QString& name)
{
    return window.findChild<ui::Section*>(name);
}

TEST(WindowLayout, RemembersWhatIsFolded)
{
    QByteArray layout;
    {
        OpenWindow w;
        ui::Section* residuals = sectionNamed(w.window, QStringLiteral("residuals"));
        ASSERT_TRUE(residuals);
        EXPECT_FALSE(residuals->isFolded());
        residuals->setFolded(true);
        layout = w.window.layoutState();
    }
    OpenWindow again;
    again.window.restoreLayout(layout);
    EXPECT_TRUE(sectionNamed(again.window, QStringLiteral("residuals"))->isFolded());
    EXPECT_FALSE(sectionNamed(again.window, QStringLiteral("convergence"))->isFolded());
    again.window.restoreLayout(QByteArray("nonsense"));   // changes nothing
    EXPECT_TRUE(sectionNamed(again.window, QStringLiteral("residuals"))->isFolded());
}

TEST(WindowLayout, IsWholeOnASmallerScreenThanItWasLeftOn)
{
    QByteArray layout;
    const QRect room = QApplication::primaryScreen()->availableGeometry();
    {
        OpenWindow w;
        w.window.setGeometry(40, 40, room.width() + 300, room.height() + 200);
        layout = w.window.layoutState();
    }
    OpenWindow again;
    again.window.restoreLayout(layout);
    QApplication::processEvents();
    EXPECT_LE(again.window.width(), room.width());
    EXPECT_LE(again.window.height(), room.height());
    EXPECT_TRUE(room.contains(again.window.geometry().topLeft()));
}

TEST(WindowLayout, RemembersTheBrightnessOfASeries)
{
    SampleWindow w;
    QApplication::processEvents();
    const double automatic = w.window.angiogramView().shownRange().window();
    w.press(Qt::Key_8);
    ASSERT_NEAR(w.window.angiogramView().shownRange().window(), 0.5 * automatic, 1e-6 * automatic);

    w.controller.document().replace({}, {});   // as if reopened later
    w.openSample();
    QApplication::processEvents();

    EXPECT_NEAR(w.window.angiogramView().shownRange().window(), 0.5 * automatic, 1e-6 * automatic);
}

TEST(WindowLayout, StartsWithTheSameBrightnessWhicheverFrameACaseWasLeftAt)
{
    SampleWindow w;
    QApplication::processEvents();
    const core::DisplayRange automatic = w.window.angiogramView().shownRange();
    w.press(Qt::Key_Home);   // to a frame without contrast agent
    ASSERT_EQ(w.current().shown().frame, 0);
    const test::TemporaryFolder folder;
    const std::string path = folder.file("case.angiopose");
    ASSERT_TRUE(io::saveCase(w.current(), path));
    OpenWindow again;
    again.drop({QString::fromStdString(path)});
    QApplication::processEvents();
    EXPECT_EQ(again.window.angiogramView().shownRange().window(), automatic.window());
    EXPECT_EQ(again.window.angiogramView().shownRange().level(), automatic.level());
}

using ui::ColumnSide;
using ui::Step;

QAbstractButton* stepButton(ui::MainWindow& window, Step step)
{
    return window.steps().findChildren<QAbstractButton*>().at(static_cast<int>(step));
}

void goTo(ui::MainWindow& window, Step step)
{
    QTest::mouseClick(stepButton(window, step), Qt::LeftButton);
    QApplication::processEvents();
}

/// Keeps each test from seeing the layout that another test stored.
struct FreshLayout {
    FreshLayout() { forget(); }
    ~FreshLayout() { forget(); }
    static void forget()
    {
        QSettings().remove(QStringLiteral("window/steps"));
        settings::layoutFollowsStep.write(true);
    }
};

TEST(WindowLayout, FoldsAColumnToARailByKeyAndHandleAndBringsItBack)
{
    const FreshLayout fresh;
    SampleWindow w;
    const int leftBefore = w.window.branches().width();
    const int imageBefore = w.window.angiogramView().width();
    w.press(Qt::Key_F5);
    QApplication::processEvents();
    EXPECT_FALSE(w.window.branches().isVisible());
    EXPECT_GT(w.window.angiogramView().width(), imageBefore + leftBefore / 2);
    auto* rail = w.window.column(ColumnSide::Left).findChild<ui::ColumnRail*>();
    ASSERT_TRUE(rail->isVisible());
    EXPECT_LE(rail->width(), 40);
    EXPECT_TRUE(rail->accessibleName().contains(rail->text()));
    QTest::mouseClick(rail, Qt::LeftButton);
    QApplication::processEvents();
    EXPECT_EQ(w.window.branches().width(), leftBefore);
    EXPECT_EQ(w.window.angiogramView().width(), imageBefore);
    EXPECT_FALSE(w.window.actions()[ui::Command::FoldLeft]->isChecked());

    ui::FoldButton* handle = nullptr;   // of the right column; the rest of the test uses only the keyboard
    for (ui::FoldButton* button : w.window.findChildren<ui::FoldButton*>()) {
        handle = button->mapTo(&w.window, QPoint()).x() > w.window.width() / 2 ? button : handle;
    }
    ASSERT_TRUE(handle && handle->isVisible());
    handle->setFocus(Qt::TabFocusReason);
    QTest::keyClick(handle, Qt::Key_Space);
    EXPECT_TRUE(w.window.column(ColumnSide::Right).isFolded());
    QWidget* now = QApplication::focusWidget();
    ASSERT_TRUE(qobject_cast<ui::ColumnRail*>(now));
    QTest::keyClick(now, Qt::Key_Space);
    EXPECT_FALSE(w.window.column(ColumnSide::Right).isFolded());
    EXPECT_EQ(QApplication::focusWidget(), handle);
}

TEST(WindowLayout, UnfoldsAColumnForWhatIsAskedOfIt)
{
    const FreshLayout fresh;
    SampleWindow w;
    w.press(Qt::Key_F5);
    w.press(Qt::Key_F6);
    w.press(Qt::Key_F, Qt::ControlModifier);   // find a branch
    EXPECT_TRUE(w.window.branches().isVisible());
    EXPECT_TRUE(w.window.branches().isAncestorOf(QApplication::focusWidget()));
    EXPECT_TRUE(w.window.column(ColumnSide::Right).isFolded());
    w.press(Qt::Key_L);   // landmarks
    EXPECT_TRUE(test::waitFor([&] { return w.window.landmarks().isVisible(); }));
}

TEST(WindowLayout, RemembersFoldedColumnsAndOpensLayoutsThatKnewNone)
{
    const FreshLayout fresh;
    QByteArray folded;
    QByteArray older;
    int width = 0;
    {
        SampleWindow w;
        width = w.window.branches().width();
        older = w.window.layoutState();
        older.chop(2 * 1 + 2 * 4);   // removes the last fields: collapsed state and width of two columns
        w.press(Qt::Key_F5);
        folded = w.window.layoutState();
    }
    SampleWindow again;
    again.window.restoreLayout(folded);
    QApplication::processEvents();
    EXPECT_FALSE(again.window.branches().isVisible());
    again.press(Qt::Key_F5);
    QApplication::processEvents();
    EXPECT_EQ(again.window.branches().width(), width);
    again.window.restoreLayout(older);
    QApplication::processEvents();
    EXPECT_TRUE(again.window.branches().isVisible());
    EXPECT_NEAR(again.window.branches().width(), width, 2);
}

class WindowStepLayout : public test::ScanWindow {
protected:
    FreshLayout fresh_;
};

TEST_F(WindowStepLayout, ShowsSlicesAndTheTreeLargeWhileAScanIsTraced)
{
    QTest::keyClick(&view(core::BodyPlane::Axial), Qt::Key_M);
    QApplication::processEvents();
    const QSize before = w.window.treeView().size();
    goTo(w.window, Step::Vessels);
    EXPECT_TRUE(w.window.column(ColumnSide::Right).isFolded());
    EXPECT_TRUE(w.window.slicesPage().isVisible());
    EXPECT_GT(w.window.treeView().width(), before.width() + 100);
    EXPECT_GT(w.window.treeView().height(), before.height() + 60);
    goTo(w.window, Step::InitialPose);
    EXPECT_FALSE(w.window.column(ColumnSide::Right).isFolded());
    EXPECT_FALSE(w.window.slicesPage().isVisible());
    EXPECT_NEAR(w.window.treeView().width(), before.width(), 2);
    goTo(w.window, Step::Review);
    EXPECT_TRUE(w.window.column(ColumnSide::Left).isFolded());
    EXPECT_GT(w.window.column(ColumnSide::Right).width(), 370);
}

TEST_F(WindowStepLayout, RemembersWhatWasChangedByHandInEachStep)
{
    goTo(w.window, Step::Review);
    w.press(Qt::Key_F5);   // shows the left column with the branches, too
    ASSERT_FALSE(w.window.column(ColumnSide::Left).isFolded());
    goTo(w.window, Step::Register);
    w.press(Qt::Key_F6);
    goTo(w.window, Step::Review);
    EXPECT_FALSE(w.window.column(ColumnSide::Left).isFolded());
    EXPECT_FALSE(w.window.column(ColumnSide::Right).isFolded());

    test::OpenWindow later;
    EXPECT_TRUE(later.window.column(ColumnSide::Right).isFolded());   // as left in the Register step
    goTo(later.window, Step::Review);
    EXPECT_FALSE(later.window.column(ColumnSide::Left).isFolded());
    later.press(Qt::Key_F5, Qt::ShiftModifier);
    EXPECT_TRUE(later.window.column(ColumnSide::Left).isFolded()) << "the step's layout as it came";
}

TEST_F(WindowStepLayout, StaysWhereItIsWhenSwitchedOff)
{
    goTo(w.window, Step::Register);
    const ui::ColumnLayout before = w.window.columns();
    w.window.actions()[ui::Command::LayoutFollowsStep]->trigger();
    goTo(w.window, Step::Vessels);
    goTo(w.window, Step::Review);
    EXPECT_EQ(w.window.columns(), before);
    test::OpenWindow later;
    EXPECT_FALSE(later.window.actions()[ui::Command::LayoutFollowsStep]->isChecked());
}

TEST_F(WindowStepLayout, WaitsForTheEndOfADrag)
{
    ui::TreeView& tree = w.window.treeView();
    goTo(w.window, Step::Register);
    QTest::mousePress(&tree, Qt::LeftButton, {}, tree.rect().center());
    QTest::mouseMove(&tree, tree.rect().center() + QPoint(20, 4));
    QTest::keyClick(stepButton(w.window, Step::Review), Qt::Key_Space);
    QTest::qWait(120);
    EXPECT_FALSE(w.window.column(ColumnSide::Left).isFolded());
    QTest::mouseRelease(&tree, Qt::LeftButton, {}, tree.rect().center() + QPoint(20, 4));
    EXPECT_TRUE(test::waitFor([&] { return w.window.column(ColumnSide::Left).isFolded(); }));
}

TEST(WindowLayout, WaitsForTheEndOfARun)
{
    const FreshLayout fresh;
    SampleWindow w;
    bool wasFoldedInRun = false;
    QObject::connect(&w.window.column(ColumnSide::Left), &ui::FoldingColumn::foldedChanged, &w.window,
                     [&] { wasFoldedInRun = wasFoldedInRun || w.controller.registration().isRunning(); });
    w.press(Qt::Key_R);
    ASSERT_TRUE(w.controller.registration().isRunning());
    QTest::mouseClick(stepButton(w.window, Step::Review), Qt::LeftButton);
    EXPECT_FALSE(w.window.column(ColumnSide::Left).isFolded());
    w.waitForRun();
    EXPECT_TRUE(test::waitFor([&] { return w.window.column(ColumnSide::Left).isFolded(); }));
    EXPECT_FALSE(wasFoldedInRun);
}

}   // namespace
}   // namespace angiopose::app
