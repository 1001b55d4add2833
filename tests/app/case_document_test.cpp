#include "app/document/case_document.h"

#include "app/document/edit_case.h"
#include "app/editing/branch_controller.h"

#include <gtest/gtest.h>
#include <QSignalSpy>

namespace angiopose::app {
namespace {

std::unique_ptr<QUndoCommand> showFrame(CaseDocument& document, int frame, int mergeId = noMergeId)
{
    const core::Case& current = document.current();
    return std::make_unique<ShowFrame>(
        document,
        ShowFrame::Values{frame, current.shown().initialCameraFromPatient, current.shown().cameraFromPatient,
                          current.shown().result},
        [] { return QStringLiteral("Frame"); }, mergeId);
}

TEST(CaseDocument, GoesBackAndForth)
{
    CaseDocument document;
    QSignalSpy changed(&document, &CaseDocument::changed);
    EXPECT_TRUE(document.push(showFrame(document, 4)));
    EXPECT_EQ(document.current().shown().frame, 4);
    document.undoStack().undo();
    EXPECT_EQ(document.current().shown().frame, 0);
    document.undoStack().redo();
    EXPECT_EQ(document.current().shown().frame, 4);
    EXPECT_EQ(changed.count(), 3);
}

TEST(CaseDocument, TakesABurstBackAsOneStep)
{
    CaseDocument document;
    document.push(showFrame(document, 1, 7));
    document.push(showFrame(document, 2, 7));
    document.push(showFrame(document, 3, 7));
    document.push(showFrame(document, 9, 8));

    EXPECT_EQ(document.undoStack().count(), 2);
    document.undoStack().undo();
    EXPECT_EQ(document.current().shown().frame, 3);
    document.undoStack().undo();
    EXPECT_EQ(document.current().shown().frame, 0);
    document.undoStack().redo();
    EXPECT_EQ(document.current().shown().frame, 3);
}

TEST(CaseDocument, RefusesEditsWhileLocked)
{
    CaseDocument document;
    QSignalSpy refused(&document, &CaseDocument::editRefused);
    document.setLocked(true);

    EXPECT_FALSE(document.push(showFrame(document, 4)));

    EXPECT_EQ(document.current().shown().frame, 0);
    EXPECT_EQ(refused.count(), 1);
    EXPECT_EQ(document.undoStack().count(), 0);
}

TEST(CaseDocument, IsModifiedOnlyWhileItDiffersFromWhatWasSaved)
{
    CaseDocument document;
    EXPECT_FALSE(document.isModified());
    document.push(showFrame(document, 4));
    EXPECT_TRUE(document.isModified());
    document.markSaved(QStringLiteral("cases/a.angiopose"), document.state());
    EXPECT_FALSE(document.isModified());
    document.undoStack().undo();
    EXPECT_TRUE(document.isModified());
    document.undoStack().redo();
    EXPECT_FALSE(document.isModified());
}

TEST(CaseDocument, StaysModifiedWhenEditedWhileItWasBeingSaved)
{
    CaseDocument document;
    document.push(showFrame(document, 1));
    document.markSaved(QStringLiteral("cases/a.angiopose"), document.state());
    document.push(showFrame(document, 2));
    const CaseState written = document.state();
    document.undoStack().undo();   // back at the position that was clean, but the file holds frame 2
    document.markSaved(QStringLiteral("cases/a.angiopose"), written);
    EXPECT_TRUE(document.isModified());
}

TEST(CaseDocument, DoesNotTakeTheNameOfACaseThatIsNoLongerOpen)
{
    CaseDocument document;
    document.replace({}, QStringLiteral("cases/first.angiopose"));
    const CaseState written = document.state();
    document.replace({}, QStringLiteral("cases/second.angiopose"));
    document.markSaved(QStringLiteral("cases/first.angiopose"), written);
    EXPECT_EQ(document.path(), QStringLiteral("cases/second.angiopose"));
}

/// A tree of two branches in two views, each with a result.
core::Case withTwoResults()
{
    core::Case session;
    core::VesselTree tree;
    tree.branches = {{1, {}, {{0, 0, 0}, {0, 0, 9}}, {}}, {2, {}, {{0, 0, 9}, {0, 5, 20}}, {}}};
    session.vessels.tree = std::make_shared<const core::VesselTree>(std::move(tree));
    session.views.resize(2);
    for (core::View& view : session.views) {
        view.result.emplace();
    }
    return session;
}

bool hasResults(const CaseDocument& document)
{
    const auto& views = document.current().views;
    EXPECT_EQ(views[0].result.has_value(), views[1].result.has_value());
    return views[0].result.has_value();
}

TEST(CaseDocument, LosesTheResultsOfAllViewsWithOtherVessels)
{
    CaseDocument document;
    document.replace(withTwoResults(), {});
    BranchController branches(document);
    branches.toggleExcluded({2});
    EXPECT_FALSE(hasResults(document));
    document.undo();
    EXPECT_TRUE(hasResults(document));
    core::VesselTree shorter = *document.current().vessels.tree;
    shorter.branches.pop_back();
    document.push(editTree(document, std::move(shorter), [] { return QStringLiteral("Delete"); }));
    EXPECT_FALSE(hasResults(document));
    document.undo();
    EXPECT_TRUE(hasResults(document));
}

}   // namespace
}   // namespace angiopose::app
