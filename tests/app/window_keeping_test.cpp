#include "tests/app/open_window.h"

#include "app/files/autosave.h"
#include "io/file_hash.h"
#include "io/support/case_lock.h"
#include "tests/support/temporary_folder.h"
#include "ui/panels/bottom_strip.h"

#include <sys/resource.h>
#include <csignal>

#include <QDir>
#include <QStandardPaths>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

bool isKnown(OpenWindow& w, const QString& words)
{
    const auto* strip = w.window.findChild<ui::BottomStrip*>();
    return test::waitFor([strip, &words] {
        const auto& reported = strip->reported().all();
        return std::ranges::any_of(reported, [&words](const auto& each) { return each.text.contains(words); });
    });
}

QDialog* questionOf(OpenWindow& w)
{
    const bool isAsked = test::waitFor([&w] { return !w.dialogs("changedElsewhere").isEmpty(); });
    return isAsked ? w.dialogs("changedElsewhere").front() : nullptr;
}

/// A case that is open in two windows and was then saved in the first one.
class TwoWindows {
public:
    TwoWindows()
    {
        first.openSample();
        path = QString::fromStdString(folder.file("study.angiopose"));
        EXPECT_TRUE(first.saveCase(path));
        second.drop({path});
        EXPECT_TRUE(isKnown(second, QStringLiteral("open elsewhere")));
        move(first, Qt::Key_Left);
        EXPECT_TRUE(first.saveCase(path));
        hash = io::sha256OfFile(path.toStdString()).value();
        move(second, Qt::Key_Right);
        second.controller.saveController().save();
    }

    static void move(OpenWindow& w, Qt::Key key)
    {
        w.window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&w.window));
        const core::RigidTransform before = w.current().shown().cameraFromPatient;
        const auto hasMoved = [&] { return test::distance(w.current().shown().cameraFromPatient, before) > 0.0; };
        w.press(key);
        if (!hasMoved()) {   // keys do not nudge yet
            w.press(Qt::Key_N);
            w.press(key);
        }
        EXPECT_TRUE(hasMoved());
    }
    bool isAsSavedFirst() const { return io::sha256OfFile(path.toStdString()).value() == hash; }

    test::TemporaryFolder folder;
    QString path;
    std::string hash;
    OpenWindow first, second;
};

TEST(WindowKeeping, NeverWritesOverWhatAnotherWindowSavedUnasked)
{
    TwoWindows w;
    QDialog* question = questionOf(w.second);
    ASSERT_TRUE(question);
    EXPECT_TRUE(w.isAsSavedFirst());
    OpenWindow::clickButton(question, QStringLiteral("Cancel"));
    EXPECT_TRUE(w.isAsSavedFirst());
    EXPECT_TRUE(w.second.controller.document().isModified());

    w.second.controller.saveController().save();   // the file still differs from what this window read
    question = questionOf(w.second);
    ASSERT_TRUE(question);
    OpenWindow::clickButton(question, QStringLiteral("Overwrite"));
    ASSERT_TRUE(test::waitFor([&w] { return !w.second.controller.document().isModified(); }));
    EXPECT_FALSE(w.isAsSavedFirst());

    TwoWindows::move(w.second, Qt::Key_Up);   // the file is now the one this window wrote
    ASSERT_TRUE(w.second.saveCase(w.path));
    EXPECT_TRUE(w.second.dialogs("changedElsewhere").isEmpty());
}

TEST(WindowKeeping, ReloadsWhatAnotherWindowSaved)
{
    TwoWindows w;
    QDialog* question = questionOf(w.second);
    ASSERT_TRUE(question);
    OpenWindow::clickButton(question, QStringLiteral("Reload"));
    ASSERT_TRUE(test::waitFor([&w] {
        return test::distance(w.second.current().shown().cameraFromPatient,
                              w.first.current().shown().cameraFromPatient) < 1e-9;
    }));
    EXPECT_TRUE(w.isAsSavedFirst());
    EXPECT_TRUE(w.second.dialogs("questionDialog").isEmpty());   // no second question
    TwoWindows::move(w.second, Qt::Key_Up);
    ASSERT_TRUE(w.second.saveCase(w.path));   // the content of the file is known
}

TEST(WindowKeeping, FreesTheCaseWhenItIsClosed)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("study.angiopose");
    {
        SampleWindow w;
        ASSERT_TRUE(w.saveCase(QString::fromStdString(path)));
        EXPECT_TRUE(test::waitFor([&path] { return io::lockHolderOf(path).has_value(); }));
    }
    EXPECT_FALSE(io::lockHolderOf(path));
    EXPECT_FALSE(std::filesystem::exists(io::lockPathOf(path)));
}

/// Prevents files from growing during its lifetime, as on a full drive.
class FullDrive {
public:
    FullDrive()
    {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit full{1, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &full);
    }
    ~FullDrive() { ::setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

TEST(WindowKeeping, SaysThatTheAutomaticCopyFailsAndTriesAgain)
{
    SampleWindow w;
    TwoWindows::move(w, Qt::Key_Left);
    const auto state = [&w] { return w.controller.saveController().saveState(); };
    {
        const FullDrive full;
        w.controller.saveController().autosaveSoon();
        EXPECT_TRUE(isKnown(w, QStringLiteral("Autosave failed")));
        EXPECT_EQ(state(), QStringLiteral("Not autosaved"));
    }
    w.controller.saveController().autosaveSoon();   // as the autosave timer does, without another edit
    EXPECT_TRUE(test::waitFor([&state] { return state().startsWith(QStringLiteral("Autosaved")); }))
        << state().toStdString();
}

TEST(WindowKeeping, OffersRecoveryThoughAFileIsGiven)
{
    const test::TemporaryFolder folder;
    const QString path = QString::fromStdString(folder.file("study.angiopose"));
    const QDir autosaves(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                         QStringLiteral("/autosave"));
    {
        SampleWindow w;
        ASSERT_TRUE(w.saveCase(path));
        ASSERT_TRUE(autosaves.mkpath(QStringLiteral(".")));
        ASSERT_TRUE(w.saveCase(autosaves.filePath(QStringLiteral("session-999997.angiopose"))));
    }
    const bool wasAccepted = settings::noticeAccepted.read();
    settings::noticeAccepted.write(true);
    {
        OpenWindow w;
        w.controller.begin({path});
        EXPECT_TRUE(test::waitFor([&w] { return w.dialogs("recoveryDialog").size() == 1; }));
        EXPECT_EQ(w.controller.document().path(), path);
    }
    settings::noticeAccepted.write(wasAccepted);
    for (const RecoveryCopy& copy : Autosave::recoveryCopies()) {
        Autosave::forget(copy);
    }
}

TEST(WindowKeeping, AsksWhereTheCaseOfARecoveredCopyWasSavedSince)
{
    const test::TemporaryFolder folder;
    const QString path = QString::fromStdString(folder.file("study.angiopose"));
    const QDir autosaves(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                         QStringLiteral("/autosave"));
    ASSERT_TRUE(autosaves.mkpath(QStringLiteral(".")));
    const QString copy = autosaves.filePath(QStringLiteral("session-999998.angiopose"));
    {
        SampleWindow w;
        ASSERT_TRUE(w.saveCase(copy));
        test::writeText((copy + QStringLiteral(".origin")).toStdString(), path.toStdString() + "\nSample");
        QTest::qWait(1100);   // file systems with time stamps in whole seconds
        ASSERT_TRUE(w.saveCase(path));
    }
    const std::string later = test::readText(path.toStdString());
    OpenWindow w;
    w.controller.saveController().offerRecovery();
    ASSERT_EQ(w.dialogs("recoveryDialog").size(), 1);
    OpenWindow::clickButton(w.dialogs("recoveryDialog").front(), QStringLiteral("Recover"));
    ASSERT_TRUE(test::waitFor([&] { return w.controller.document().path() == path; }));
    w.controller.saveController().save();
    ASSERT_TRUE(questionOf(w));
    EXPECT_EQ(test::readText(path.toStdString()), later);
    for (const RecoveryCopy& left : Autosave::recoveryCopies()) {
        Autosave::forget(left);
    }
}

TEST(WindowKeeping, CleansUpAfterSessionsThatWereKilled)
{
    const QDir autosaves(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                         QStringLiteral("/autosave"));
    ASSERT_TRUE(autosaves.mkpath(QStringLiteral(".")));
    const QString stale = autosaves.filePath(QStringLiteral("session-999996.angiopose.lock"));
    test::writeText(stale.toStdString(), "999996\nangiopose\n" + QSysInfo::machineHostName().toStdString() + "\n");
    const OpenWindow w;
    EXPECT_TRUE(test::waitFor([&stale] { return !QFile::exists(stale); }));
}

}   // namespace
}   // namespace angiopose::app
