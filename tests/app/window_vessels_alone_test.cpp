#include "app/files/autosave.h"
#include "io/vessel_tree_file.h"
#include "tests/app/open_window.h"
#include "tests/support/for_each.h"

#include <QDir>
#include <QFile>
#include <QListView>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTreeWidget>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Fixture: vessels without an angiogram: three branches that meet, from a table.
class WindowVesselsAlone : public ::testing::Test {
protected:
    void SetUp() override
    {
        QFile file(folder.filePath(QStringLiteral("fork.csv")));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("x,y,z,radius,branch\n");
        for (int branch = 1; branch <= 3; ++branch) {
            for (int i = 0; i <= 10; ++i) {
                const int along = branch == 1 ? i - 10 : i;
                const int aside = branch == 1 ? 0 : branch == 2 ? i : -i;
                file.write(QByteArray::number(5 * along) + ',' + QByteArray::number(5 * aside) + ",0,1.5," +
                           QByteArray::number(branch) + '\n');
            }
        }
        file.close();
        w.drop({file.fileName()});
        ASSERT_TRUE(w.current().vessels.tree);
        ASSERT_EQ(w.current().vessels.tree->branches.size(), 3U);
    }
    void deleteABranch()
    {
        w.controller.branches().select({w.current().vessels.tree->branches.back().id});
        QTest::keyClick(w.window.branches().list(), Qt::Key_Delete);
        ASSERT_EQ(w.current().vessels.tree->branches.size(), 2U);
    }
    /// Answers the file dialog and returns the path of the saved vessels.
    QString nameThem()
    {
        const QString path = folder.filePath(QStringLiteral("kept.vtp"));
        w.saveAs(path);
        return path;
    }

    const QTemporaryDir folder;
    OpenWindow w;
};

TEST_F(WindowVesselsAlone, AreOfferedAsCenterlinesWhereACaseCannotBeSaved)
{
    deleteABranch();
    w.press(Qt::Key_S, Qt::ControlModifier);
    ASSERT_EQ(w.dialogs("vesselsQuestion").size(), 1);
    EXPECT_TRUE(w.dialogs("messageDialog").isEmpty());
    OpenWindow::clickButton(w.dialogs("vesselsQuestion").front(), QStringLiteral("Save vessels…"));
    const auto kept = io::readVesselTree(nameThem().toStdString());
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_EQ(kept.value().branches.size(), 2U);
    EXPECT_EQ(kept.value().pointCount(), w.current().vessels.tree->pointCount());
    EXPECT_TRUE(test::waitFor([this] { return !w.controller.saveController().hasUnsavedWork(); }));
}

TEST_F(WindowVesselsAlone, LeaveWordsWhereTheAngiogramWillBe)
{
    const QImage seen = w.window.angiogramView().grab().toImage();
    int bright = 0;
    test::forEachPixel(seen.width(), seen.height(),
                       [&](int x, int y) { bright += qGray(seen.pixel(x, y)) > 80 ? 1 : 0; });
    EXPECT_GT(bright, 200);
}

TEST_F(WindowVesselsAlone, AreExportedFromTheMenu)
{
    w.window.actions()[ui::Command::ExportVessels]->trigger();
    const auto written = io::readVesselTree(nameThem().toStdString());
    ASSERT_TRUE(written) << written.error().message;
    EXPECT_EQ(written.value().branches.size(), 3U);
    EXPECT_NEAR(written.value().branches.front().radiusMm.front(), 1.5, 1e-6);
}

TEST_F(WindowVesselsAlone, AreSavedWhenTheWindowIsClosed)
{
    deleteABranch();
    w.window.close();
    ASSERT_EQ(w.dialogs("closeQuestion").size(), 1);
    OpenWindow::clickButton(w.dialogs("closeQuestion").front(), QStringLiteral("Save vessels and close"));
    nameThem();
    EXPECT_TRUE(test::waitFor([this] { return !w.window.isVisible(); }));
}

TEST_F(WindowVesselsAlone, CloseWithoutAskingWhenTheyWereOnlyOpened)
{
    w.window.close();
    EXPECT_TRUE(w.dialogs("closeQuestion").isEmpty());
    EXPECT_TRUE(test::waitFor([this] { return !w.window.isVisible(); }));
}

TEST_F(WindowVesselsAlone, AreRecoveredAfterACrash)
{
    deleteABranch();
    const core::VesselTree before = *w.current().vessels.tree;
    w.controller.saveController().autosaveSoon();
    const QDir copies(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                      QStringLiteral("/autosave"));
    const QString own = copies.filePath(QStringLiteral("session-%1.vtp").arg(QCoreApplication::applicationPid()));
    ASSERT_TRUE(test::waitFor([&own] { return QFile::exists(own); }));
    const QString left = copies.filePath(QStringLiteral("session-999993.vtp"));   // as left by a crash
    ASSERT_TRUE(QFile::copy(own, left));

    OpenWindow again;
    again.controller.saveController().offerRecovery();
    ASSERT_EQ(again.dialogs("recoveryDialog").size(), 1);
    QDialog* dialog = again.dialogs("recoveryDialog").front();
    auto* list = dialog->findChild<QTreeWidget*>();
    const auto rows = list->findItems(QStringLiteral("Vessels without an angiogram"), Qt::MatchExactly);
    ASSERT_EQ(rows.size(), 1);
    list->setCurrentItem(rows.front());
    OpenWindow::clickButton(dialog, QStringLiteral("Recover"));

    ASSERT_TRUE(test::waitFor([&again] { return again.current().vessels.tree != nullptr; }));
    EXPECT_EQ(again.current().vessels.tree->pointCount(), before.pointCount());
    EXPECT_FALSE(QFile::exists(left));
    EXPECT_TRUE(QFile::exists(QString::fromStdString(again.current().vessels.file.path)));
    EXPECT_TRUE(again.controller.saveController().hasUnsavedWork()) << "closing asks where they belong";
    QFile::remove(own);
}

}   // namespace
}   // namespace angiopose::app
