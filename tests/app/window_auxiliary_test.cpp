#include "tests/app/open_window.h"

#include <QLabel>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

/// Draws a rectangle with the mouse, in fractions of the view's size.
void drawLasso(OpenWindow& w, const QRectF& shares, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    QWidget& view = w.window.angiogramView();
    const auto at = [&view](double x, double y) {
        return QPoint(static_cast<int>(x * view.width()), static_cast<int>(y * view.height()));
    };
    const std::array corners{at(shares.left(), shares.top()), at(shares.right(), shares.top()),
                             at(shares.right(), shares.bottom()), at(shares.left(), shares.bottom())};
    QTest::mousePress(&view, Qt::LeftButton, modifiers, corners[0]);
    for (const QPoint& corner : corners) {
        QMouseEvent move(QEvent::MouseMove, corner, view.mapToGlobal(corner), Qt::NoButton, Qt::LeftButton, modifiers);
        QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, modifiers, corners[3]);
}

TEST(WindowAuxiliary, TakesTheBranchesInsideALasso)
{
    SampleWindow w;
    QAction* lasso = w.window.actions()[ui::Command::Lasso];
    w.press(Qt::Key_L, Qt::ControlModifier);
    ASSERT_TRUE(lasso->isChecked());

    drawLasso(w, {0.01, 0.01, 0.98, 0.98});
    const std::size_t all = w.current().vessels.auxiliaryBranchIds.size();
    EXPECT_GT(all, w.current().vessels.tree->branches.size() / 2);
    EXPECT_EQ(w.history().count(), 1);

    drawLasso(w, {0.01, 0.01, 0.5, 0.98}, Qt::ControlModifier);   // removes some
    const std::size_t fewer = w.current().vessels.auxiliaryBranchIds.size();
    EXPECT_LT(fewer, all);
    drawLasso(w, {0.01, 0.01, 0.5, 0.98}, Qt::ShiftModifier);   // adds them again
    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds.size(), all);
    w.press(Qt::Key_Escape);
    EXPECT_FALSE(lasso->isChecked());
}

TEST(WindowAuxiliary, SaysWhenALassoHoldsNothing)
{
    SampleWindow w;
    w.press(Qt::Key_L, Qt::ControlModifier);
    drawLasso(w, {0.0, 0.0, 0.03, 0.03});
    EXPECT_TRUE(w.current().vessels.auxiliaryBranchIds.empty());
    EXPECT_EQ(w.history().count(), 0);
}

TEST(WindowAuxiliary, AdvisesWhichBranchesPinThePose)
{
    SampleWindow w;
    w.press(Qt::Key_A, Qt::ShiftModifier);
    AuxiliaryController& auxiliary = w.controller.poses().auxiliary();
    ASSERT_TRUE(auxiliary.dialog());
    ASSERT_TRUE(test::waitFor([&] { return !auxiliary.suggestion().empty(); }));
    EXPECT_LT(auxiliary.suggestion().size(), w.current().vessels.tree->branches.size());

    OpenWindow::clickButton(auxiliary.dialog(), QStringLiteral("Use these"));

    std::vector<int> expected = auxiliary.suggestion();
    std::ranges::sort(expected);
    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds, expected);
    const auto labels = auxiliary.dialog()->findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(
        labels, [](const QLabel* label) { return label->text().contains(QStringLiteral("depth")); }));
    EXPECT_TRUE(std::ranges::any_of(
        labels, [](const QLabel* label) { return label->text().startsWith(QStringLiteral("Auxiliary: ")); }));
}

TEST(WindowAuxiliary, OffersAMethodThatUsesTheChoiceAndSaysWhatTheDefaultDoes)
{
    SampleWindow w;
    w.press(Qt::Key_A, Qt::ShiftModifier);
    QDialog* dialog = w.controller.poses().auxiliary().dialog();
    ASSERT_TRUE(dialog);
    const auto says = [dialog](const QString& words) {
        return std::ranges::any_of(dialog->findChildren<QLabel*>(),
                                   [&words](const QLabel* label) { return label->text().contains(words); });
    };
    EXPECT_TRUE(says(QStringLiteral("components that they constrain")));
    OpenWindow::clickButton(dialog, QStringLiteral("Use DynaWeightPnP instead"));
    EXPECT_EQ(w.current().options.method, "dynaweight");
    EXPECT_TRUE(test::waitFor([&] { return !says(QStringLiteral("components that they constrain")); }));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().options.method, "angiopose");
}

TEST(WindowAuxiliary, ChoosesByGenerationAndRadius)
{
    SampleWindow w;
    AuxiliaryController& auxiliary = w.controller.poses().auxiliary();
    const auto& branches = w.current().vessels.tree->branches;
    auxiliary.selectByRadius(0.0);
    const std::size_t wide = w.current().vessels.auxiliaryBranchIds.size();
    auxiliary.selectByRadius(1e6);   // no branch is so wide: reports this and keeps the subset
    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds.size(), wide);
    const auto firstGenerations =
        std::ranges::count_if(branches, [](const auto& branch) { return branch.generation == 0; });
    if (firstGenerations > 0) {
        auxiliary.selectGenerations(0);
        EXPECT_EQ(static_cast<std::ptrdiff_t>(w.current().vessels.auxiliaryBranchIds.size()), firstGenerations);
    }
}

}   // namespace
}   // namespace angiopose::app
