#include "app/words/view_words.h"
#include "core/messages/messages.h"
#include "tests/app/open_window.h"
#include "tests/support/test_data.h"

#include "ui/dialogs/missing_inputs.h"

#include <QCheckBox>
#include <QFile>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QTemporaryDir>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::OpenWindow;

QString phantom(const char* relative)
{
    return QString::fromStdString(test::dataFile(std::string("coronary-phantom-xa/") + relative).string());
}

QListWidget& strip(OpenWindow& w)
{
    return *w.window.views().findChild<QListWidget*>();
}

void answer(OpenWindow& w, const QString& verb)
{
    const auto questions = w.dialogs("viewQuestion");
    ASSERT_EQ(questions.size(), 1);
    OpenWindow::clickButton(questions.front(), verb);
    QApplication::processEvents();
    w.window.activateWindow();   // there is no window manager to do it
    EXPECT_TRUE(QTest::qWaitForWindowActive(&w.window));
}

void openBothViews(OpenWindow& w)
{
    w.drop({phantom("cases/IM4.angiopose")});
    w.waitForJudgement();
    w.drop({phantom("views-A/IM3.dcm")});
    answer(w, QStringLiteral("Add as a view"));
}

QString wordsOfLine(OpenWindow& w, int line)
{
    return strip(w).item(line)->text();
}

TEST(WindowViews, ASecondAngiogramStandsBesideTheFirst)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    w.drop({phantom("cases/IM4.angiopose")});
    EXPECT_FALSE(w.window.views().isVisible());
    const auto first = w.current().shown().angiogram;
    w.drop({phantom("views-A/IM3.dcm")});
    answer(w, QStringLiteral("Add as a view"));

    EXPECT_EQ(w.current().shown().angiogram, first);
    ASSERT_EQ(w.current().views.size(), 2U);
    EXPECT_TRUE(w.window.views().isVisible());
    EXPECT_EQ(w.window.views().count(), 2);
    // The agreement of each view is computed automatically.
    EXPECT_TRUE(
        test::waitFor([&] { return wordsOfLine(w, 0).contains("mm ·") && wordsOfLine(w, 1).contains("mm ·"); }));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().views.size(), 1U);
    EXPECT_FALSE(w.window.views().isVisible());
}

TEST(WindowViews, NothingOfAClosedCaseIsKept)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openBothViews(w);
    ASSERT_TRUE(
        test::waitFor([&] { return wordsOfLine(w, 0).contains("mm ·") && wordsOfLine(w, 1).contains("mm ·"); }));
    const std::weak_ptr<const core::VesselTree> tree = w.current().vessels.tree;
    const std::weak_ptr<const core::Angiogram> own = w.current().shown().angiogram;
    const std::weak_ptr<const core::Angiogram> other = w.current().views[1].angiogram;
    ASSERT_FALSE(tree.expired() || own.expired() || other.expired());
    const core::Case nothing;
    w.controller.document().replace(nothing, {});
    EXPECT_TRUE(test::waitFor([&] { return tree.expired() && own.expired() && other.expired(); }))
        << tree.use_count() << " " << own.use_count() << " " << other.use_count();
}

TEST(WindowViews, ASecondAngiogramCanTakeThePlaceOfTheFirst)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    w.drop({phantom("cases/IM4.angiopose")});
    const auto first = w.current().shown().angiogram;
    w.drop({phantom("views-A/IM3.dcm")});
    answer(w, QStringLiteral("Cancel"));
    EXPECT_EQ(w.current().shown().angiogram, first);
    w.drop({phantom("views-A/IM3.dcm")});
    answer(w, QStringLiteral("Replace the angiogram"));
    EXPECT_NE(w.current().shown().angiogram, first);
    EXPECT_EQ(w.current().views.size(), 1U);
}

TEST(WindowViews, AClickInTheStripShowsAnotherAndUndoTheFirst)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openBothViews(w);
    const auto first = w.current().shown().angiogram;
    const auto tree = w.current().vessels.tree;
    const int shown = strip(w).currentRow();
    const QRect other = strip(w).visualItemRect(strip(w).item(1 - shown));
    QTest::mouseClick(strip(w).viewport(), Qt::LeftButton, {}, other.center());
    QApplication::processEvents();
    EXPECT_NE(w.current().shown().angiogram, first);
    EXPECT_EQ(w.current().vessels.tree, tree);
    EXPECT_EQ(strip(w).currentRow(), 1 - shown);   // rows keep their positions
    EXPECT_NE(w.current().shown().imageFile.path.find("IM3"), std::string::npos);

    w.press(Qt::Key_Tab, Qt::ControlModifier);
    EXPECT_EQ(w.current().shown().angiogram, first);
    EXPECT_EQ(strip(w).currentRow(), shown);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().shown().angiogram, first);
}

TEST(WindowViews, RegisterFindsOnePoseForAllAndIsOneStep)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openBothViews(w);
    const core::RigidTransform before = w.current().shown().cameraFromPatient;
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    EXPECT_LT(w.current().shown().result->metrics.medianPx, 3.0);
    ASSERT_TRUE(w.current().views[1].result);
    EXPECT_LT(w.current().views[1].result->metrics.medianPx, 3.0);
    EXPECT_TRUE(std::ranges::any_of(w.current().shown().result->warnings, [](const core::Message& said) {
        return said.text().find(core::messages::tableUnknown().text()) != std::string::npos;
    })) << "these headers tell no table: the second view adds no depth";
    EXPECT_EQ(w.current().shown().snapshots.size(), 1U);

    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().shown().cameraFromPatient.matrix(), before.matrix());
    EXPECT_FALSE(w.current().views[1].result);

    auto* together = w.window.registration().findChild<QCheckBox*>();
    ASSERT_TRUE(together->isVisible());
    QTest::mouseClick(together, Qt::LeftButton, {}, {8, together->height() / 2});
    ASSERT_FALSE(together->isChecked());
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    EXPECT_FALSE(w.current().views[1].result);
}

TEST(WindowViews, ANudgeMovesTheVesselsInAllOfThem)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openBothViews(w);
    const auto otherPose = [&w] { return w.current().views[1].cameraFromPatient; };
    const core::RigidTransform before = otherPose();
    const core::RigidTransform between = before * w.current().shown().cameraFromPatient.inverse();
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_GT(test::distance(otherPose(), before), 1.0);
    EXPECT_LT(test::distance(otherPose() * w.current().shown().cameraFromPatient.inverse(), between), 1e-9);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(test::distance(otherPose(), before), 0.0);

    auto* together = w.window.registration().findChild<QCheckBox*>();
    QTest::mouseClick(together, Qt::LeftButton, {}, {8, together->height() / 2});
    w.press(Qt::Key_Right);
    EXPECT_EQ(test::distance(otherPose(), before), 0.0);
}

TEST(WindowViews, ASavedCaseShowsThemAgain)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("both.angiopose"));
    Eigen::Matrix4d otherPose;
    {
        OpenWindow w;
        openBothViews(w);
        otherPose = w.current().views[1].cameraFromPatient.matrix();
        w.controller.saveController().saveTo(path);
        EXPECT_TRUE(test::waitFor([&] { return !w.controller.document().isModified(); }));
    }
    OpenWindow again;
    again.drop({path});
    ASSERT_EQ(again.current().views.size(), 2U);
    ASSERT_TRUE(again.current().views[1].angiogram);
    EXPECT_EQ(again.current().views[1].cameraFromPatient.matrix(), otherPose);
    EXPECT_EQ(again.window.views().count(), 2);
}

TEST(WindowViews, KeepTheirNumbersWhereverTheyAreShownAndWhenReopened)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("both.angiopose"));
    QStringList names;
    {
        OpenWindow w;
        openBothViews(w);
        EXPECT_TRUE(wordsOfLine(w, 0).startsWith(QStringLiteral("1 · ")));
        EXPECT_TRUE(wordsOfLine(w, 1).startsWith(QStringLiteral("2 · ")));   // an added view comes last
        names = {wordsOfLine(w, 0).section(u'\n', 0, 0), wordsOfLine(w, 1).section(u'\n', 0, 0)};
        QTest::mouseClick(strip(w).viewport(), Qt::LeftButton, {}, strip(w).visualItemRect(strip(w).item(1)).center());
        EXPECT_EQ(w.current().shownView, 1U);
        EXPECT_EQ(wordsOfLine(w, 1).section(u'\n', 0, 0), names[1]);
        w.controller.saveController().saveTo(path);
        EXPECT_TRUE(test::waitFor([&] { return !w.controller.document().isModified(); }));
    }
    OpenWindow again;
    again.drop({path});
    EXPECT_EQ(again.current().shownView, 1U);
    EXPECT_EQ(strip(again).currentRow(), 1);
    for (int line = 0; line < 2; ++line) {
        EXPECT_EQ(wordsOfLine(again, line).section(u'\n', 0, 0), names[line]);
    }
}

QStringList wordsOfResult(OpenWindow& w)
{
    QStringList words;
    for (const QLabel* label : w.window.result().findChildren<QLabel*>()) {
        if (label->isVisible()) {
            words << label->text();
        }
    }
    return words;
}

/// A predicate: the current assessment belongs to the shown pose.
auto isJudged(OpenWindow& w)
{
    return [&w] {
        const SharedEvaluation evaluation = w.controller.evaluation();
        return evaluation &&
               evaluation->result.cameraFromPatient.matrix() == w.current().shown().cameraFromPatient.matrix();
    };
}

TEST(WindowViews, AReopenedCaseSaysOfItsFitWhatItSaidBefore)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("both.angiopose"));
    QStringList words, steps;
    std::vector<core::RegistrationResult> results;
    const auto stepsOf = [](OpenWindow& w) {
        QStringList texts;
        for (const QLabel* label : w.window.steps().findChildren<QLabel*>()) {
            texts << label->text();
        }
        return texts;
    };
    {
        OpenWindow w;
        openBothViews(w);
        w.registerVessels();
        EXPECT_TRUE(test::waitFor(isJudged(w)));
        words = wordsOfResult(w);
        steps = stepsOf(w);
        results = {*w.current().views[0].result, *w.current().views[1].result};
        w.controller.saveController().saveTo(path);
        EXPECT_TRUE(test::waitFor([&] { return !w.controller.document().isModified(); }));
    }
    OpenWindow again;
    again.drop({path});
    EXPECT_TRUE(test::waitFor(isJudged(again)));
    EXPECT_EQ(wordsOfResult(again).join(u'\n').toStdString(), words.join(u'\n').toStdString());
    EXPECT_EQ(stepsOf(again).join(u'\n').toStdString(), steps.join(u'\n').toStdString());
    for (std::size_t k = 0; k < 2; ++k) {
        const auto& result = again.current().views[k].result;
        ASSERT_TRUE(result) << k;
        EXPECT_EQ(result->method, results[k].method);
        EXPECT_EQ(result->trustworthy, results[k].trustworthy);
        EXPECT_EQ(result->warnings, results[k].warnings);
        EXPECT_EQ(result->history.size(), results[k].history.size());
        EXPECT_EQ(result->provenance.time, results[k].provenance.time);
        EXPECT_FALSE(result->provenance.time.empty());
    }
    EXPECT_FALSE(again.controller.document().isModified());
}

TEST(WindowViews, AViewKeepsTheNameThatTheUserGivesIt)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("named.angiopose"));
    OpenWindow w;
    openBothViews(w);
    const int shown = strip(w).currentRow();
    emit w.window.views().menuRequested(1 - shown, {});
    QMenu* menu = w.window.findChild<QMenu*>(QStringLiteral("viewMenu"));
    ASSERT_TRUE(menu);
    menu->actions().at(1)->trigger();
    menu->close();
    auto* dialog = w.window.findChild<QInputDialog*>();
    ASSERT_TRUE(dialog);
    dialog->setTextValue(QStringLiteral(" before the stent "));
    dialog->accept();
    EXPECT_EQ(w.current().views[1].name, "before the stent");
    EXPECT_TRUE(wordsOfLine(w, 1 - shown).contains(QStringLiteral("· before the stent")));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().views[1].name, "");
    w.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    w.controller.saveController().saveTo(path);
    EXPECT_TRUE(test::waitFor([&] { return !w.controller.document().isModified(); }));
    OpenWindow again;
    again.drop({path});
    ASSERT_EQ(again.current().views.size(), 2U);
    EXPECT_EQ(again.current().views[1].name, "before the stent");
}

TEST(WindowViews, AViewThatHasMovedIsLookedForAndTheCaseOpensWithout)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const QTemporaryDir folder;
    const QTemporaryDir elsewhere;
    const QString path = folder.filePath(QStringLiteral("both.angiopose"));
    const QString image = elsewhere.filePath(QStringLiteral("second.dcm"));
    QFile::copy(phantom("views-A/IM3.dcm"), image);
    {
        OpenWindow w;
        w.drop({phantom("cases/IM4.angiopose")});
        w.drop({image});
        answer(w, QStringLiteral("Add as a view"));
        w.controller.saveController().saveTo(path);
        EXPECT_TRUE(test::waitFor([&] { return !w.controller.document().isModified(); }));
    }
    ASSERT_TRUE(QFile::rename(image, elsewhere.filePath(QStringLiteral("renamed.dat"))));
    OpenWindow again;
    again.drop({path});
    const auto dialogs = again.dialogs("missingInputs");
    ASSERT_EQ(dialogs.size(), 1);
    OpenWindow::clickButton(dialogs.front(), QStringLiteral("Open anyway"));
    EXPECT_TRUE(test::waitFor([&] { return again.current().shown().angiogram != nullptr; }));
    ASSERT_EQ(again.current().views.size(), 2U);   // stays in the case without its image
    EXPECT_FALSE(again.current().views[1].angiogram);
    EXPECT_TRUE(wordsOfLine(again, 1 - strip(again).currentRow()).contains("not found"));
}

TEST(WindowViews, DeleteTakesTheShownOneOutAndShowsTheNext)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    OpenWindow w;
    openBothViews(w);
    strip(w).setFocus();
    QTest::keyClick(&strip(w), Qt::Key_Delete);
    EXPECT_EQ(w.current().views.size(), 1U);
    EXPECT_NE(w.current().shown().imageFile.path.find("IM3"), std::string::npos);
    EXPECT_TRUE(w.current().vessels.tree);   // no branch was deleted
    EXPECT_EQ(w.current().vessels.tree->branches.size(), 11U);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().views.size(), 2U);
    EXPECT_NE(w.current().shown().imageFile.path.find("IM4"), std::string::npos);
}

TEST(ViewWords, NameAViewByItsNumberAloneWhereNothingElseIsKnown)
{
    EXPECT_EQ(numberedTitle(std::vector<core::View>(2), 1), QStringLiteral("2"));
}

}   // namespace
}   // namespace angiopose::app
