#include "tests/app/open_window.h"

#include "app/document/edit_case.h"
#include "app/files/autosave.h"
#include "tests/support/temporary_folder.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTreeWidget>

#include <filesystem>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Copies as left by two crashed sessions: one of a saved case and one of a case that was never saved.
class CrashedSessions {
public:
    CrashedSessions()
    {
        test::SampleWindow w;
        saved_ = QString::fromStdString(folder_.file("study.angiopose"));
        save(w, saved_);
        w.press(Qt::Key_N);
        w.press(Qt::Key_Left);
        pose_ = w.current().shown().cameraFromPatient;
        save(w, copyOf(1));
        w.press(Qt::Key_Left);
        save(w, copyOf(2));
        writeOrigin(1, saved_.toUtf8());   // format of older versions
        writeOrigin(2, "\nHead phantom");
    }
    ~CrashedSessions()
    {
        for (const RecoveryCopy& copy : Autosave::recoveryCopies()) {
            Autosave::forget(copy);
        }
    }

    static QString copyOf(int session)
    {
        const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                          QStringLiteral("/autosave"));
        EXPECT_TRUE(folder.mkpath(QStringLiteral(".")));
        return folder.filePath(QStringLiteral("session-99999%1.angiopose").arg(session));
    }
    const QString& saved() const { return saved_; }
    const core::RigidTransform& pose() const { return pose_; }

private:
    static void writeOrigin(int session, const QByteArray& text)
    {
        QFile origin(copyOf(session) + QStringLiteral(".origin"));
        EXPECT_TRUE(origin.open(QIODevice::WriteOnly));
        origin.write(text);
    }

    static void save(OpenWindow& w, const QString& path) { EXPECT_TRUE(w.saveCase(path)); }

    test::TemporaryFolder folder_;
    QString saved_;
    core::RigidTransform pose_;
};

QTreeWidgetItem* itemOf(const QDialog& dialog, const QString& name)
{
    const auto items = dialog.findChild<QTreeWidget*>()->findItems(name, Qt::MatchExactly);
    return items.isEmpty() ? nullptr : items.front();
}

TEST(WindowRecovery, OpensTheChosenCopyUnderTheNameOfItsCase)
{
    const CrashedSessions crashed;
    OpenWindow w;
    w.controller.saveController().offerRecovery();
    ASSERT_EQ(w.dialogs("recoveryDialog").size(), 1);
    QDialog* dialog = w.dialogs("recoveryDialog").front();
    ASSERT_EQ(dialog->findChild<QTreeWidget*>()->topLevelItemCount(), 2);
    QTreeWidgetItem* copy = itemOf(*dialog, QStringLiteral("study.angiopose"));
    ASSERT_TRUE(copy);
    dialog->findChild<QTreeWidget*>()->setCurrentItem(copy);

    OpenWindow::clickButton(dialog, QStringLiteral("Recover"));

    ASSERT_TRUE(test::waitFor([&] { return !w.controller.isLoading() && !w.controller.document().isEmpty(); }));
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, crashed.pose()), 1e-9);
    EXPECT_EQ(w.controller.document().path(), crashed.saved());   // Save writes to the original file
    EXPECT_TRUE(w.controller.document().isModified());
    ASSERT_TRUE(test::waitFor([] { return !QFile::exists(CrashedSessions::copyOf(1)); }));
    EXPECT_TRUE(QFile::exists(CrashedSessions::copyOf(2)));   // no decision was made about the other copy
}

TEST(WindowRecovery, DeletesOnlyWhatWasChosen)
{
    const CrashedSessions crashed;
    OpenWindow w;
    w.controller.saveController().offerRecovery();
    QDialog* dialog = w.dialogs("recoveryDialog").front();
    dialog->findChild<QTreeWidget*>()->setCurrentItem(itemOf(*dialog, QStringLiteral("Head phantom (not saved)")));
    OpenWindow::clickButton(dialog, QStringLiteral("Delete"));
    EXPECT_FALSE(QFile::exists(CrashedSessions::copyOf(2)));
    OpenWindow::clickButton(dialog, QStringLiteral("Not now"));
    EXPECT_TRUE(QFile::exists(CrashedSessions::copyOf(1)));
}

TEST(WindowRecovery, OpensACaseWhoseInputsHaveMoved)
{
    const CrashedSessions crashed;
    namespace fs = std::filesystem;
    const test::TemporaryFolder folder;
    const fs::path home = fs::path(folder.file("x")).parent_path();
    OpenWindow w;
    w.drop({crashed.saved()});
    core::Case inputs = w.current();
    const fs::path tree = home / fs::path(inputs.vessels.file.path).filename();
    const fs::path image = home / fs::path(inputs.shown().imageFile.path).filename();
    fs::copy_file(inputs.vessels.file.path, tree);
    fs::copy_file(inputs.shown().imageFile.path, image);
    auto wanted = w.current();
    wanted.vessels.file.path = tree.string();
    wanted.shown().imageFile.path = image.string();
    w.controller.document().push(addInputs(w.controller.document(), wanted, [] { return QStringLiteral("move"); }));
    const QString path = QString::fromStdString((home / "moved.angiopose").string());
    ASSERT_TRUE(w.saveCase(path));
    fs::create_directories(home / "below");
    fs::rename(tree, home / "below" / ("another-name" + tree.extension().string()));
    fs::rename(image, home / "below" / image.filename());

    OpenWindow again;
    again.drop({path});

    ASSERT_TRUE(again.current().vessels.tree);
    EXPECT_TRUE(again.dialogs("messageDialog").isEmpty());
    EXPECT_TRUE(again.controller.document().isModified());   // the new paths are not in the file yet
    EXPECT_EQ(again.current().vessels.tree->pointCount(), inputs.vessels.tree->pointCount());
}

TEST(WindowRecovery, AsksWhereInputsAreThatNobodyFinds)
{
    const CrashedSessions crashed;
    namespace fs = std::filesystem;
    const test::TemporaryFolder folder;
    const std::string path = folder.file("lost.angiopose");
    std::string text = test::readText(crashed.saved().toStdString());
    const std::size_t hash = text.find("\"sha256\": \"");
    ASSERT_NE(hash, std::string::npos);
    text.replace(hash + 11, 64, std::string(64, '0'));   // a hash that no file has
    const std::size_t name = text.find("\"path\": \"");
    text.insert(name + 9, "gone/");
    test::writeText(path, text);
    OpenWindow w;
    w.drop({QString::fromStdString(path)});
    EXPECT_TRUE(w.controller.document().isEmpty());
    ASSERT_EQ(w.dialogs("missingInputs").size(), 1);
    OpenWindow::clickButton(w.dialogs("missingInputs").front(), QStringLiteral("Cancel"));
}

}   // namespace
}   // namespace angiopose::app
