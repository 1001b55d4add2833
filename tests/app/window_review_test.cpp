#include "tests/app/open_window.h"

#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::SampleWindow;

TEST(WindowReview, ZoomsToTheWorstBranchAndSelectsIt)
{
    SampleWindow w;
    const double fitted = w.window.angiogramView().zoom();
    const auto& branches = w.controller.evaluation()->result.branches;
    const auto worst = std::ranges::max_element(branches, {}, &core::BranchResidual::medianPx);

    w.press(Qt::Key_W);

    EXPECT_EQ(w.controller.branches().marks().selected, std::set<int>{worst->branchId});
    EXPECT_NE(w.window.angiogramView().zoom(), fitted);
    w.press(Qt::Key_W);
    EXPECT_FALSE(w.controller.branches().marks().selected.contains(worst->branchId));
    w.press(Qt::Key_1);
    EXPECT_NEAR(w.window.angiogramView().zoom(), fitted, 1e-9);
}

TEST(WindowReview, ReplaysARunWithoutTouchingTheCase)
{
    SampleWindow w;
    w.press(Qt::Key_P);   // no registration yet
    EXPECT_FALSE(w.window.actions()[ui::Command::Replay]->isChecked());
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    const core::RigidTransform found = w.current().shown().cameraFromPatient;
    const int history = w.history().count();

    w.press(Qt::Key_P);

    EXPECT_TRUE(w.window.actions()[ui::Command::Replay]->isChecked());
    QAction* replay = w.window.actions()[ui::Command::Replay];
    EXPECT_TRUE(test::waitFor([replay] { return !replay->isChecked(); }));
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, found), 0.0);
    EXPECT_EQ(w.history().count(), history);
}

TEST(WindowReview, SwingsUntilEscapeAndEndsOtherMotions)
{
    SampleWindow w;
    w.press(Qt::Key_F);
    w.press(Qt::Key_U);
    EXPECT_TRUE(w.window.actions()[ui::Command::Swing]->isChecked());
    EXPECT_FALSE(w.window.actions()[ui::Command::Flicker]->isChecked());
    QTest::qWait(120);
    w.press(Qt::Key_Escape);
    EXPECT_FALSE(w.window.actions()[ui::Command::Swing]->isChecked());
    EXPECT_EQ(w.history().count(), 0);
}

TEST(WindowReview, AReplayThatEndsASwingGoesOn)
{
    SampleWindow w;
    w.registerVessels();
    QAction* swing = w.window.actions()[ui::Command::Swing];
    QAction* replay = w.window.actions()[ui::Command::Replay];
    ASSERT_TRUE(test::waitFor([&] {
        w.press(Qt::Key_U);
        return swing->isChecked();   // works once the uncertainty is known
    }));
    w.press(Qt::Key_P);
    EXPECT_FALSE(swing->isChecked());
    EXPECT_TRUE(replay->isChecked());
    EXPECT_EQ(w.controller.preview().shown(), PreviewSource::Replay);
    EXPECT_TRUE(test::waitFor([replay] { return !replay->isChecked(); }));   // the replay ended
    EXPECT_FALSE(w.controller.preview().shown());
}

TEST(WindowReview, GoesFromSwipeToLensToNothing)
{
    SampleWindow w;
    const std::array order{ui::Cutout::Shape::RightOf, ui::Cutout::Shape::Disc, ui::Cutout::Shape::None};
    for (const ui::Cutout::Shape shape : order) {
        w.press(Qt::Key_S);
        EXPECT_EQ(w.window.angiogramView().cutout(), shape);
    }
}

TEST(WindowReview, ChangesContrastAroundTheSameLevel)
{
    SampleWindow w;
    ui::AngiogramView& view = w.window.angiogramView();
    const core::DisplayRange before = view.shownRange();
    w.press(Qt::Key_8);
    EXPECT_NEAR(view.shownRange().window(), 0.5 * before.window(), 1e-9);
    EXPECT_NEAR(view.shownRange().level(), before.level(), 1e-9);
    w.press(Qt::Key_9);
    const auto [low, high] = std::ranges::minmax(view.scene().frame().pixels);
    EXPECT_NEAR(view.shownRange().low, low, 1e-3);
    EXPECT_NEAR(view.shownRange().high, high, 1e-3);
    w.press(Qt::Key_0);
    EXPECT_NEAR(view.shownRange().window(), before.window(), 1e-9);
}

TEST(WindowReview, CopiesThePoseAsAMatrix)
{
    SampleWindow w;
    w.press(Qt::Key_C, Qt::ControlModifier);
    const QStringList rows = QGuiApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    ASSERT_EQ(rows.size(), 4);
    const Eigen::Matrix4d matrix = w.current().shown().cameraFromPatient.matrix();
    for (int row = 0; row < 4; ++row) {
        const QStringList cells = rows[row].split(QLatin1Char('\t'));
        ASSERT_EQ(cells.size(), 4);
        for (int column = 0; column < 4; ++column) {
            EXPECT_NEAR(cells[column].toDouble(), matrix(row, column), 1e-8);
        }
    }
}

TEST(WindowReview, SaysThatRegisterKeepsWhatIsLocked)
{
    SampleWindow w;
    const auto says = [&w] {
        const auto labels = w.window.registration().findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().contains(QStringLiteral("Registration keeps the locked"));
        });
    };
    EXPECT_FALSE(says());
    ui::PoseLocks locks{};
    locks[2] = true;
    w.controller.pose().setLocks(locks);
    EXPECT_TRUE(says());
    w.controller.pose().setLocks({});
    EXPECT_FALSE(says());
}

TEST(WindowReview, FindsKeysByTyping)
{
    test::OpenWindow w;
    w.press(Qt::Key_F1, Qt::ControlModifier);
    ASSERT_EQ(w.dialogs("keySheet").size(), 1);
    const QDialog* sheet = w.dialogs("keySheet").front();
    auto* search = sheet->findChild<QLineEdit*>();
    const auto* list = sheet->findChild<QTreeWidget*>();
    ASSERT_TRUE(search && list);
    const auto shows = [list](const char* words) {
        return !list->findItems(QString::fromLatin1(words), Qt::MatchContains, 1).isEmpty();
    };
    EXPECT_TRUE(shows("Nudge mode"));
    QTest::keyClicks(search, QStringLiteral("worst"));
    EXPECT_TRUE(shows("worst branch"));
    EXPECT_FALSE(shows("Nudge mode"));
    QTest::keyClicks(search, QStringLiteral("xyz"));
    EXPECT_EQ(list->topLevelItemCount(), 0);
}

TEST(WindowReview, ChoosesAuxiliaryBranchesByViewAndWidth)
{
    SampleWindow w;
    w.press(Qt::Key_V, Qt::ShiftModifier);
    const std::size_t half = (w.current().vessels.tree->branches.size() + 1) / 2;
    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds.size(), half);
    w.press(Qt::Key_W);   // one branch fills the view
    w.press(Qt::Key_V);
    EXPECT_LT(w.current().vessels.auxiliaryBranchIds.size(), w.current().vessels.tree->branches.size());
    const std::set<int> selected = w.controller.branches().marks().selected;
    EXPECT_TRUE(w.controller.branches().marks().auxiliary.contains(*selected.begin()));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds.size(), half);
}

}   // namespace
}   // namespace angiopose::app
