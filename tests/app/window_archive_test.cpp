#include "tests/app/archive_window.h"
#include "ui/archive/node_dialog.h"
#include "ui/dialogs/study_browser.h"
#include "ui/dialogs/study_list.h"

namespace angiopose::app {
namespace {

using test::Heartbeat;
using test::OpenWindow;

class WindowArchive : public test::ArchiveWindow {};

TEST_F(WindowArchive, FirstOneIsAddedByKeysEditedAndRemoved)
{
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    OpenWindow::clickButton(dialog, QStringLiteral("Add…"));
    const auto editors = dialog->findChildren<ui::NodeDialog*>();
    ASSERT_EQ(editors.size(), 1);
    QWidget* host = editors.front()->findChild<QWidget*>(QStringLiteral("nodeHost"));
    QTest::keyClicks(host, QStringLiteral("10.0.0.7"));
    QTest::keyClick(host, Qt::Key_Return);
    EXPECT_TRUE(editors.front()->isVisible()) << "it has no name yet";
    EXPECT_TRUE(editors.front()->line().statusText().contains(QStringLiteral("name"))) << "which is said";
    QTest::keyClicks(editors.front()->findChild<QWidget*>(QStringLiteral("nodeName")), QStringLiteral("pacs"));
    QTest::keyClick(host, Qt::Key_Return);
    ASSERT_TRUE(test::waitFor([&] { return dialog->nodes().node() == QStringLiteral("pacs"); }));
    const auto stored = io::readArchiveSettings(io::defaultArchiveSettingsFile());
    ASSERT_TRUE(stored) << "where the command line finds it";
    ASSERT_EQ(stored.value().nodes.size(), 1u);
    EXPECT_EQ(stored.value().nodes.front().host, "10.0.0.7");

    OpenWindow::clickButton(dialog, QStringLiteral("Remove…"));
    const auto questions = w.window.findChildren<QDialog*>(QStringLiteral("archiveRemoval"));
    ASSERT_EQ(questions.size(), 1);
    OpenWindow::clickButton(questions.front(), QStringLiteral("Remove"));
    EXPECT_TRUE(test::waitFor([&] { return dialog->nodes().node().isEmpty(); }));
}

TEST_F(WindowArchive, DeadOneIsToldInTenSecondsWhileTheWindowLives)
{
    const test::SilentPeer peer;
    know({nodeAt(peer.port())});
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    const Heartbeat beat;
    const test::Stopwatch watch;
    OpenWindow::clickButton(dialog, QStringLiteral("Test connection"));
    EXPECT_TRUE(dialog->line().isBusy());
    const QString said = statusText(dialog->line());
    EXPECT_LT(watch.seconds(), 10.0);
    EXPECT_TRUE(said.contains(QStringLiteral("did not answer"))) << said.toStdString();
    EXPECT_TRUE(said.contains(QStringLiteral("Check"))) << "what to do";
    RecordProperty("longestGapMs", static_cast<int>(beat.longestMs()));
    EXPECT_LT(beat.longestMs(), 200);
}

TEST_F(WindowArchive, StopEndsTheAskingOfADeadOne)
{
    const test::SilentPeer peer;
    know({nodeAt(peer.port())});
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    OpenWindow::clickButton(dialog, QStringLiteral("Search"));
    QTest::qWait(300);
    const test::Stopwatch watch;
    OpenWindow::clickButton(dialog, QStringLiteral("Stop"));
    EXPECT_EQ(statusText(dialog->line()), QStringLiteral("Stopped."));
    EXPECT_LT(watch.seconds(), 3.0);
}

TEST_F(WindowArchive, ClosedWindowDoesNotWaitForADeadOne)
{
    const test::SilentPeer peer;
    know({nodeAt(peer.port())});
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    OpenWindow::clickButton(dialog, QStringLiteral("Test connection"));
    const test::Stopwatch watch;
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_TRUE(test::waitFor([this] { return w.dialogs("archiveDialog").isEmpty(); }));
    EXPECT_LT(watch.seconds(), 1.0);
}

TEST_F(WindowArchive, RealOneAnswers)
{
    NEEDS_ORTHANC();
    know({nodeAt(orthanc_->dicomPort())});
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    OpenWindow::clickButton(dialog, QStringLiteral("Test connection"));
    EXPECT_EQ(statusText(dialog->line()), QStringLiteral("pacs responded and accepted the connection."));
}

TEST_F(WindowArchive, WhatIsFoundIsRetrievedAndOffered)
{
    NEEDS_ORTHANC();
    store(3);
    know({nodeAt(orthanc_->dicomPort())});
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    search(*dialog, QStringLiteral("Nobody"));
    EXPECT_EQ(dialog->list().topLevelItemCount(), 0);
    search(*dialog, QStringLiteral("M"));   // QTest keys have no umlauts
    ASSERT_EQ(dialog->list().topLevelItemCount(), 1);
    QTreeWidgetItem* study = dialog->list().topLevelItem(0);
    EXPECT_EQ(study->text(0), QStringLiteral("Müller Änne"));
    EXPECT_EQ(study->text(2), QStringLiteral("2024-03-05"));
    EXPECT_EQ(dialog->focusWidget(), &dialog->list());
    QTest::keyClick(&dialog->list(), Qt::Key_Right);
    EXPECT_TRUE(test::waitFor([&] { return study->childCount() == 2; })) << "its series";

    const Heartbeat beat;
    QTest::keyClick(&dialog->list(), Qt::Key_Return);
    ui::StudyBrowser* browser = nullptr;
    ASSERT_TRUE(test::waitFor([&] {
        const auto shown = w.dialogs("studyBrowser");
        browser = shown.isEmpty() ? nullptr : qobject_cast<ui::StudyBrowser*>(shown.front());
        return browser != nullptr;
    }));
    EXPECT_TRUE(test::waitFor([&] { return browser->list().seriesCount() == 2; }));
    EXPECT_TRUE(w.dialogs("archiveDialog").isEmpty());
    RecordProperty("longestGapMs", static_cast<int>(beat.longestMs()));
    QTest::keyClick(browser, Qt::Key_Escape);
    QTest::qWait(0);
    dialog = opened();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(dialog->list().topLevelItemCount(), 1) << "what was found is there again";
}

TEST_F(WindowArchive, WhatIsRetrievedIsInTheAuditFile)
{
    NEEDS_ORTHANC();
    store(1);
    know({nodeAt(orthanc_->dicomPort())});
    const test::AuditFile audit(folder);
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    search(*dialog, QStringLiteral("M"));
    ASSERT_EQ(dialog->list().topLevelItemCount(), 1);
    OpenWindow::clickButton(dialog, QStringLiteral("Retrieve"));
    ASSERT_TRUE(test::waitFor([&] { return audit.text().contains(QStringLiteral("retrieved")); }));
    const QString line = audit.text();
    EXPECT_TRUE(line.contains(QStringLiteral("\"archive\":\"pacs\""))) << line.toStdString();
    for (const char* series : {"2.25.4711.61", "2.25.4711.62"}) {
        EXPECT_TRUE(line.contains(QLatin1String(series) + QStringLiteral(".1.dcm\",\"sha256\""))) << line.toStdString();
    }
}

TEST_F(WindowArchive, StoppedRetrievalKeepsWhatCameAndOffersIt)
{
    NEEDS_ORTHANC();
    store(1, 512);
    // The first object, of half a MB, arrives complete; the connection hangs during the second.
    const test::CuttingProxy line(orthanc_->dicomPort(), 800'000, test::CuttingProxy::AtEnd::Hang);
    io::ArchiveNode node = nodeAt(line.port());
    node.responseTimeoutSeconds = 60;
    know({node});
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    search(*dialog, QStringLiteral("M"));   // QTest keys have no umlauts
    ASSERT_EQ(dialog->list().topLevelItemCount(), 1);
    OpenWindow::clickButton(dialog, QStringLiteral("Retrieve"));
    const auto progress = [&] { return dialog->line().statusText().startsWith(QStringLiteral("1 of 2 objects")); };
    EXPECT_TRUE(test::waitFor(progress)) << dialog->line().statusText().toStdString();
    OpenWindow::clickButton(dialog, QStringLiteral("Stop"));
    const QString said = statusText(dialog->line());
    EXPECT_TRUE(said.startsWith(QStringLiteral("Stopped. 1 of 2 objects were retrieved."))) << said.toStdString();
    for (const QPushButton* button : dialog->findChildren<QPushButton*>()) {
        EXPECT_TRUE(button->text() != QStringLiteral("Open retrieved") || button->isVisible());
    }
    EXPECT_TRUE(test::halfFiles(folder.file("cache")).empty());
}

TEST_F(WindowArchive, SearchIsRememberedButNotWhoWasLookedFor)
{
    know({nodeAt(test::freePort())});
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    dialog->fields().showSearch(
        {QStringLiteral("Meier"), QStringLiteral("4711"), QStringLiteral("31.1.2024"), {}, QStringLiteral("XA")});
    OpenWindow::clickButton(dialog, QStringLiteral("Search"));
    EXPECT_TRUE(statusText(dialog->line()).contains(QStringLiteral("cannot be reached")));
    dialog->reject();
    QTest::qWait(0);
    dialog = opened();
    ASSERT_TRUE(dialog);
    const ui::ArchiveSearch search = dialog->fields().search();
    EXPECT_TRUE(search.patientName.isEmpty() && search.patientId.isEmpty());
    EXPECT_EQ(search.from, QStringLiteral("31.1.2024"));
    EXPECT_EQ(search.modality, QStringLiteral("XA"));
    for (const QString& key : QSettings().allKeys()) {
        EXPECT_FALSE(QSettings().value(key).toString().contains(QStringLiteral("Meier"))) << key.toStdString();
    }
    dialog->fields().showSearch({{}, {}, QStringLiteral("yesterday"), {}, {}});
    OpenWindow::clickButton(dialog, QStringLiteral("Search"));
    EXPECT_TRUE(statusText(dialog->line()).contains(QStringLiteral("not a date")));
}

TEST_F(WindowArchive, CacheIsLimitedAndEmptied)
{
    know({nodeAt(test::freePort())});
    folder.write("cache/1.2/1.2.3/1.2.3.4.dcm", std::string(2'000'000, 'x'));
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    const auto* size = dialog->findChild<QLabel*>(QStringLiteral("cacheSize"));
    EXPECT_TRUE(size->text().contains(QStringLiteral("2 MB"))) << size->text().toStdString();
    auto* limit = dialog->findChild<QLineEdit*>(QStringLiteral("cacheLimit"));
    limit->selectAll();
    QTest::keyClicks(limit, QStringLiteral("5"));
    QTest::keyClick(limit, Qt::Key_Return);
    const auto isStored = [] {
        const auto stored = io::readArchiveSettings(io::defaultArchiveSettingsFile());
        return stored && stored.value().cacheBytes == 5'000'000'000;
    };
    EXPECT_TRUE(test::waitFor(isStored));
    folder.write("cache/1.2/1.2.4/1.2.4.5.dcm", std::string(200'000'000, 'x'));
    dialog->reject();
    QTest::qWait(0);
    dialog = opened();
    ASSERT_TRUE(dialog);
    limit = dialog->findChild<QLineEdit*>(QStringLiteral("cacheLimit"));
    limit->selectAll();
    QTest::keyClicks(limit, QStringLiteral("0.1"));
    QTest::keyClick(limit, Qt::Key_Return);
    QDialog* dropping = nullptr;
    const auto isAsked = [&] { return (dropping = dialog->findChild<QDialog*>(QStringLiteral("cacheDropping"))); };
    ASSERT_TRUE(test::waitFor([&] { return isAsked() != nullptr; }));
    EXPECT_TRUE(dropping->isVisible()) << "Return does not answer it at once";
    OpenWindow::clickButton(dropping, QStringLiteral("Cancel"));
    EXPECT_TRUE(test::waitFor([&] { return limit->text().startsWith(u'5'); }));
    EXPECT_TRUE(isStored()) << test::readText(io::defaultArchiveSettingsFile());
    EXPECT_TRUE(std::filesystem::exists(folder.file("cache/1.2/1.2.4/1.2.4.5.dcm")));
    size = dialog->findChild<QLabel*>(QStringLiteral("cacheSize"));
    OpenWindow::clickButton(dialog, QStringLiteral("Empty…"));
    const auto questions = w.window.findChildren<QDialog*>(QStringLiteral("cacheEmptying"));
    ASSERT_EQ(questions.size(), 1);
    OpenWindow::clickButton(questions.front(), QStringLiteral("Empty"));
    EXPECT_TRUE(test::waitFor([&] { return size->text().contains(QStringLiteral("empty")); }));
    EXPECT_FALSE(std::filesystem::exists(folder.file("cache/1.2/1.2.3/1.2.3.4.dcm")));
}

}   // namespace
}   // namespace angiopose::app
