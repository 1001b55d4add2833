#include "app/files/autosave.h"
#include "app/files/recent_cases.h"
#include "app/preferences/private_mode.h"
#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"
#include "ui/dialogs/deidentify_dialog.h"
#include "ui/panels/fault_bar.h"

#include <QDirIterator>
#include <QListWidget>
#include <QPlainTextEdit>

#include <filesystem>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;
namespace fs = std::filesystem;

QString ofTest(const std::string& path)
{
    return QString::fromStdString(path);
}

/// Fixture: a saved sample with planted words in its title, folder and name.
class WindowPrivacy : public ::testing::Test {
protected:
    WindowPrivacy()
    {
        fs::create_directories(folder.file("PLANTED folder"));
        casePath = ofTest(folder.file("PLANTED folder/PLANTEDcase.angiopose"));
        SampleWindow w;
        auto planted = w.current();
        planted.title = "PLANTED title";
        w.controller.document().replace(planted, {});
        save(w);
        clearStoredData();
    }
    ~WindowPrivacy() override { settings::privateMode.write(false); }

    void save(OpenWindow& w) const { EXPECT_TRUE(w.saveCase(casePath)); }

    /// Files in this user's settings, cache, data and state folders that contain the word in their content or name.
    static QStringList traces(const QByteArray& word)
    {
        QSettings().sync();
        QStringList found;
        for (QDirIterator each(qEnvironmentVariable("XDG_CONFIG_HOME"), QDir::Files | QDir::Hidden,
                               QDirIterator::Subdirectories);
             each.hasNext();) {
            QFile file(each.next());
            if (file.fileName().toUtf8().contains(word) ||
                (file.open(QIODevice::ReadOnly) && file.readAll().contains(word))) {
                found << file.fileName();
            }
        }
        return found;
    }

    void session() const
    {
        OpenWindow w;
        w.drop({casePath});
        w.waitForJudgement();
        w.press(Qt::Key_N);
        w.press(Qt::Key_Left);
        w.controller.saveController().autosaveSoon();
        w.window.actions()[ui::Command::ExportPose]->trigger();
        w.saveAs(ofTest(folder.file("PLANTED folder/exported.tfm")));
        save(w);
        QTest::qWait(500);   // time for a thumbnail to be written
        shownTitle = w.window.windowTitle();
        w.controller.saveController().discardAutosave();
    }

    test::TemporaryFolder folder;
    QString casePath;
    mutable QString shownTitle;
};

TEST_F(WindowPrivacy, WithoutItCasesAreRemembered)
{
    session();
    EXPECT_TRUE(shownTitle.contains(QStringLiteral("PLANTED"))) << shownTitle.toStdString();
    EXPECT_FALSE(traces("PLANTED").isEmpty()) << "the test looks in the wrong place";
}

TEST_F(WindowPrivacy, PrivateModeLeavesNothingBehind)
{
    settings::privateMode.write(true);
    session();
    EXPECT_FALSE(shownTitle.contains(QStringLiteral("PLANTED"))) << shownTitle.toStdString();
    EXPECT_TRUE(recentCases().isEmpty());
    EXPECT_TRUE(traces("PLANTED").isEmpty()) << traces("PLANTED").join(u'\n').toStdString();
}

TEST_F(WindowPrivacy, TurningItOnForgetsAfterAsking)
{
    session();
    OpenWindow w;
    QAction* mode = w.window.actions()[ui::Command::PrivateMode];
    mode->trigger();
    ASSERT_EQ(w.dialogs("privacyDialog").size(), 1);
    OpenWindow::clickButton(w.dialogs("privacyDialog").front(), QStringLiteral("Cancel"));
    EXPECT_FALSE(mode->isChecked());
    EXPECT_FALSE(recentCases().isEmpty());
    mode->trigger();
    OpenWindow::clickButton(w.dialogs("privacyDialog").front(), QStringLiteral("Turn on"));
    EXPECT_TRUE(mode->isChecked());
    EXPECT_TRUE(recentCases().isEmpty());
    EXPECT_TRUE(traces("PLANTED").isEmpty()) << traces("PLANTED").join(u'\n').toStdString();
}

TEST_F(WindowPrivacy, ExportsAreNamedAfterNobody)
{
    settings::privateMode.write(true);
    OpenWindow w;
    w.drop({casePath});
    w.waitForJudgement();
    w.window.actions()[ui::Command::ExportPose]->trigger();
    QFileDialog* files = w.window.findChild<QFileDialog*>();
    ASSERT_TRUE(files);
    EXPECT_TRUE(files->selectedFiles().front().endsWith(QStringLiteral("/case.pose.json")))
        << files->selectedFiles().front().toStdString();
    files->reject();
    EXPECT_TRUE(caseForExport(w.current()).title.empty());
}

TEST_F(WindowPrivacy, SupportBundleIsShownAndNamesNobody)
{
    OpenWindow w;
    w.drop({casePath});
    w.waitForJudgement();
    w.window.strip().remember(QStringLiteral("Written: %1, Opened of Dr Unheardof").arg(casePath));
    w.window.actions()[ui::Command::SupportBundle]->trigger();
    ASSERT_TRUE(test::waitFor([&] { return w.dialogs("supportDialog").size() == 1; }));
    QDialog* dialog = w.dialogs("supportDialog").front();
    auto* names = dialog->findChild<QListWidget*>();
    QString all;
    for (int i = 0; i < names->count(); ++i) {
        names->setCurrentRow(i);
        all += names->item(i)->text() + QLatin1Char('\n') + dialog->findChild<QPlainTextEdit*>()->toPlainText();
    }
    for (const char* part : {"Qt: 6", "OpenGL", "branches", "log.txt", "settings.txt", "Written"}) {
        EXPECT_TRUE(all.contains(QLatin1String(part))) << part << " is lacking in " << all.toStdString();
    }
    for (const char* secret : {"PLANTED", "Unheardof"}) {
        EXPECT_FALSE(all.contains(QLatin1String(secret))) << secret << " in " << all.toStdString();
    }
    OpenWindow::clickButton(dialog, QStringLiteral("Save…"));
    w.saveAs(ofTest(folder.file("bundle.zip")));
}

TEST_F(WindowPrivacy, AuditFileSaysWhatWasOpenedAndWritten)
{
    const QString audit = ofTest(folder.file("audit.jsonl"));
    settings::auditFile.write(audit);
    session();
    const auto text = [&audit] { return test::readText(audit.toStdString()); };
    const auto hasAll = [&text] {
        const std::string lines = text();
        return lines.find("\"opened\"") != std::string::npos && lines.find("\"exported\"") != std::string::npos &&
               lines.find("\"saved\"") != std::string::npos;
    };
    EXPECT_TRUE(test::waitFor(hasAll)) << text();
    EXPECT_NE(text().find("exported.tfm\",\"sha256\""), std::string::npos) << text();
}

TEST(WindowFaults, AreToldOnceWithThePlaceOfTheDump)
{
    const QDir state(qEnvironmentVariable("XDG_STATE_HOME"));
    ASSERT_TRUE(state.mkpath(QStringLiteral("angiopose/crashes")));
    const QString dump = state.filePath(QStringLiteral("angiopose/crashes/angiopose-2026-01-01T000000Z-1.txt"));
    test::writeText(dump.toStdString(), "program: angiopose 0\nsignal: SIGSEGV (11)\nend\n");
    settings::noticeAccepted.write(true);
    {
        OpenWindow w;
        w.controller.begin({});
        EXPECT_TRUE(w.window.faultBar().isVisible());
        EXPECT_TRUE(w.window.faultBar().findChild<QLabel*>()->text().contains(dump));
        emit w.window.faultBar().bundleRequested();
        EXPECT_TRUE(test::waitFor([&] { return w.dialogs("supportDialog").size() == 1; }));
    }
    OpenWindow again;
    again.controller.begin({});
    EXPECT_FALSE(again.window.faultBar().isVisible());
    QFile::remove(dump);
}

TEST(WindowDeidentify, WritesFilesAndListsWhatItRefused)
{
    const test::TemporaryFolder folder;
    test::writeText(folder.file("letter.txt"), "Dear Jane Doe");
    SampleWindow w;
    w.window.actions()[ui::Command::DeidentifyFiles]->trigger();
    ASSERT_EQ(w.dialogs("deidentifyDialog").size(), 1);
    auto* dialog = static_cast<ui::DeidentifyDialog*>(w.dialogs("deidentifyDialog").front());
    dialog->addPaths({ofTest(w.current().shown().imageFile.path), ofTest(folder.file("letter.txt"))});
    dialog->setOutputFolder(ofTest(folder.file("out")));
    OpenWindow::clickButton(dialog, QStringLiteral("Write"));
    ASSERT_TRUE(test::waitFor([&] { return w.dialogs("messageDialog").size() == 1; }));
    EXPECT_TRUE(fs::exists(folder.file("out/series-1/00001.dcm")));
    EXPECT_FALSE(w.controller.isBusy());
}

}   // namespace
}   // namespace angiopose::app
