#include "core/vessel/edit_tree.h"
#include "core/vessel/tree_gaps.h"
#include "tests/app/open_window.h"
#include "ui/controls/number_field.h"
#include "ui/dialogs/prune_dialog.h"
#include "ui/panels/result_sentences.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QTemporaryDir>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::OpenWindow;

class WindowTree : public ::testing::Test {
protected:
    QListView& list() { return *w.window.branches().list(); }
    const core::VesselTree& tree() { return *w.current().vessels.tree; }
    int idAt(std::size_t index) { return tree().branches[index].id; }
    void select(const std::set<int>& ids) { w.controller.branches().select(ids); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(&list(), key, modifiers);
    }
    QString rowText(int row) { return list().model()->index(row, 0).data().toString(); }

    test::SampleWindow w;
};

TEST_F(WindowTree, DeletesBranchesWithTheirMarksAndBringsThemBack)
{
    const auto before = w.current().vessels.tree;
    const int gone = idAt(before->branches.size() - 1);
    select({gone});
    press(Qt::Key_A);
    ASSERT_EQ(w.current().vessels.auxiliaryBranchIds, std::vector{gone});

    press(Qt::Key_Delete);
    EXPECT_EQ(tree().branches.size(), before->branches.size() - 1);
    EXPECT_EQ(tree().find(gone), nullptr);
    EXPECT_TRUE(w.current().vessels.auxiliaryBranchIds.empty());
    EXPECT_TRUE(w.current().vessels.isTreeEdited);
    EXPECT_TRUE(w.history().undoText().startsWith(QStringLiteral("Delete")));
    EXPECT_TRUE(w.controller.branches().marks().selected.empty());
    EXPECT_EQ(list().model()->rowCount(), static_cast<int>(tree().branches.size()));

    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vessels.tree, before);
    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds, std::vector{gone});
    EXPECT_FALSE(w.current().vessels.isTreeEdited);
}

TEST_F(WindowTree, NeverDeletesEverything)
{
    const auto before = w.current().vessels.tree;
    press(Qt::Key_A, Qt::ControlModifier);
    press(Qt::Key_Delete);
    EXPECT_EQ(w.current().vessels.tree, before);
}

TEST_F(WindowTree, DropsTheResultButKeepsAMovedPose)
{
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    const core::RigidTransform pose = w.current().shown().cameraFromPatient;
    select({idAt(tree().branches.size() - 1)});
    press(Qt::Key_Delete);
    EXPECT_FALSE(w.current().shown().result);
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, pose), 1e-12);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(w.current().shown().result);
}

TEST_F(WindowTree, CutsJoinsAndSmooths)
{
    const auto before = w.current().vessels.tree;
    const int id = idAt(0);
    const auto& points = tree().branches[0].pointsInPatient;
    emit w.window.treeView().pointPicked(points[points.size() / 2]);   // as a click on the branch does
    select({id});
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_EQ(tree().branches.size(), before->branches.size() + 1);
    const int part = tree().branches.back().id;
    EXPECT_NEAR(static_cast<double>(tree().find(id)->pointsInPatient.size()), 0.5 * static_cast<double>(points.size()),
                1.6);

    select({id, part});
    press(Qt::Key_J, Qt::ControlModifier);
    ASSERT_EQ(tree().branches.size(), before->branches.size());
    EXPECT_EQ(tree().find(id)->pointsInPatient.size(), points.size());
    EXPECT_NEAR(tree().find(id)->lengthMm(), before->find(id)->lengthMm(), 1e-9);

    select({id});
    press(Qt::Key_M, Qt::ControlModifier);
    EXPECT_LT(tree().find(id)->lengthMm(), before->find(id)->lengthMm());
    EXPECT_EQ(tree().find(id)->pointsInPatient.front(), points.front());
    EXPECT_EQ(w.history().count(), 3);
}

TEST_F(WindowTree, RenamesInTheListAndKeepsTheResult)
{
    w.registerVessels();
    const int id = idAt(2);
    select({id});
    press(Qt::Key_F2);
    auto* editor = list().findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(editor, QStringLiteral("LAD x"));   // letters that are shortcuts elsewhere
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return tree().find(id)->name == "LAD x"; }, 5000));
    EXPECT_TRUE(w.current().shown().result);
    EXPECT_TRUE(w.current().vessels.excludedBranchIds.empty());
    EXPECT_EQ(w.controller.branches().marks().selected, std::set{id});
    EXPECT_EQ(list().selectionModel()->selectedIndexes().size(), 1);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(tree().find(id)->name, "LAD x");
}

TEST_F(WindowTree, HidesBranchesFromTheViewsOnly)
{
    const int id = idAt(1);
    ASSERT_TRUE(w.window.angiogramView().scene().extentOf(id));
    select({id});
    press(Qt::Key_H, Qt::ShiftModifier);
    EXPECT_EQ(w.current().vessels.hiddenBranchIds, std::vector{id});
    EXPECT_FALSE(w.window.angiogramView().scene().extentOf(id));
    EXPECT_TRUE(tree().find(id));
    press(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(w.current().vessels.hiddenBranchIds.empty());
    EXPECT_TRUE(w.window.angiogramView().scene().extentOf(id));
}

TEST_F(WindowTree, PrunesWhatTheDialogCounts)
{
    press(Qt::Key_P, Qt::ControlModifier);
    const QList<QDialog*> asked = w.dialogs("pruneDialog");
    ASSERT_EQ(asked.size(), 1);
    auto* length = asked.front()->findChildren<ui::NumberField*>().front();
    double limitMm = 5.0;
    while (core::pruneTree(tree(), limitMm, 0.0).value().branches.size() == tree().branches.size()) {
        limitMm += 5.0;
    }
    length->setFocus();
    length->selectAll();
    QTest::keyClicks(length, QString::number(limitMm, 'f', 1));
    QTest::keyClick(length, Qt::Key_Tab);
    const std::size_t before = tree().branches.size();
    OpenWindow::clickButton(asked.front(), QStringLiteral("Prune"));
    EXPECT_LT(tree().branches.size(), before);
    EXPECT_TRUE(w.history().undoText().startsWith(QStringLiteral("Prune")));
}

TEST_F(WindowTree, RootsAtTheChosenEnd)
{
    const std::vector<core::VesselNode> nodes = core::findNodes(tree());
    const auto free = std::ranges::find_if(nodes, [this](const core::VesselNode& node) {
        return !node.isBifurcation() && node.branchIds.front() != idAt(0);
    });
    ASSERT_NE(free, nodes.end());
    emit w.window.treeView().pointPicked(free->pointInPatient);
    select({free->branchIds.front()});
    press(Qt::Key_Home, Qt::ControlModifier);
    EXPECT_LT((tree().branches.front().pointsInPatient.front() - free->pointInPatient).norm(), 1e-9);
    EXPECT_EQ(tree().branches.front().generation, 0);
}

TEST_F(WindowTree, AdvisesHowToMendABrokenTree)
{
    const auto isBroken = [this] { return w.window.actions()[ui::Command::BridgeGap]->isEnabled(); };
    // Removes a segment from a branch without descendants; the rest beyond the segment becomes a separate piece.
    const auto twig = std::ranges::find_if(tree().branches, [this](const core::VesselBranch& branch) {
        const auto left = core::removeSubtree(tree(), branch.id);
        return branch.lengthMm() > 30.0 && branch.pointsInPatient.size() > 30 && left &&
               left.value().branches.size() + 1 == tree().branches.size();
    });
    ASSERT_NE(twig, tree().branches.end());
    const auto keptAlive = w.current().vessels.tree;
    const auto& points = twig->pointsInPatient;
    emit w.window.treeView().pointPicked(points[points.size() * 2 / 5]);
    select({twig->id});
    press(Qt::Key_K, Qt::ControlModifier);
    emit w.window.treeView().pointPicked(points[points.size() * 3 / 5]);
    const int middle = tree().branches.back().id;
    select({middle});
    press(Qt::Key_K, Qt::ControlModifier);
    select({middle});
    press(Qt::Key_Delete);
    ASSERT_EQ(tree().branches.size(), keptAlive->branches.size() + 1);
    ASSERT_TRUE(test::waitFor(isBroken));

    press(Qt::Key_G, Qt::ControlModifier);
    EXPECT_TRUE(w.history().undoText().startsWith(QStringLiteral("Join")));
    EXPECT_EQ(core::componentCount(tree()), 1);
    EXPECT_EQ(tree().branches.size(), keptAlive->branches.size());
    EXPECT_FALSE(isBroken());
}

TEST_F(WindowTree, SortsAndFiltersTheList)
{
    auto* order = w.window.branches().findChild<QComboBox*>();
    ASSERT_TRUE(order);
    order->setCurrentText(QStringLiteral("by length"));
    double last = 1e9;
    for (int row = 0; row < list().model()->rowCount(); ++row) {
        const QString name = rowText(row);
        for (const core::VesselBranch& branch : tree().branches) {
            if (ui::displayName(branch) == name) {
                EXPECT_LE(branch.lengthMm(), last);
                last = branch.lengthMm();
            }
        }
    }
    const int id = idAt(3);
    const QString name = ui::displayName(*tree().find(id));
    press(Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(QApplication::focusWidget(), name);
    ASSERT_GE(list().model()->rowCount(), 1);
    EXPECT_LT(list().model()->rowCount(), static_cast<int>(tree().branches.size()));
    const QRect row = list().visualRect(list().model()->index(0, 0));
    QTest::mouseClick(list().viewport(), Qt::LeftButton, Qt::NoModifier, row.topLeft() + QPoint(40, 8));
    const std::set<int> selected = w.controller.branches().marks().selected;
    ASSERT_EQ(selected.size(), 1U);
    EXPECT_EQ(ui::displayName(*tree().find(*selected.begin())), rowText(0));
}

TEST_F(WindowTree, EditsSurviveSavingAndReopening)
{
    const QTemporaryDir folder;
    select({idAt(1)});
    press(Qt::Key_Delete);
    select({idAt(1)});
    press(Qt::Key_H, Qt::ShiftModifier);
    const core::VesselTree edited = tree();
    const QString path = folder.filePath(QStringLiteral("edited.angiopose"));
    w.controller.saveController().saveTo(path);
    ASSERT_TRUE(test::waitFor([this] { return !w.controller.document().isModified(); }));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    w.history().setClean();

    w.drop({path});
    EXPECT_TRUE(w.current().vessels.isTreeEdited);
    ASSERT_EQ(tree().branches.size(), edited.branches.size());
    for (std::size_t i = 0; i < edited.branches.size(); ++i) {
        EXPECT_EQ(tree().branches[i].id, edited.branches[i].id);
        EXPECT_EQ(tree().branches[i].pointsInPatient, edited.branches[i].pointsInPatient);
    }
    EXPECT_EQ(w.current().vessels.hiddenBranchIds.size(), 1U);
}

}   // namespace
}   // namespace angiopose::app
