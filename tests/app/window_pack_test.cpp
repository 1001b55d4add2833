#include "io/case/case_file.h"
#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"

#include <QCheckBox>
#include <QDir>
#include <QProcess>

namespace angiopose::app {
namespace {

using test::OpenWindow;

class WindowPack : public ::testing::Test {
protected:
    QDialog* asked()
    {
        w.window.actions()[ui::Command::ShareCase]->trigger();
        const auto dialogs = w.dialogs("packDialog");
        return dialogs.size() == 1 ? dialogs.front() : nullptr;
    }

    void chooseFile(const std::string& path)
    {
        QFileDialog* files = nullptr;
        const auto isThere = [&] { return (files = w.window.findChild<QFileDialog*>()) && files->isVisible(); };
        ASSERT_TRUE(test::waitFor(isThere));
        files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(QString::fromStdString(path));
        QTest::mouseClick(files->findChild<QDialogButtonBox*>()->buttons().front(), Qt::LeftButton);
    }

    OpenWindow w;
    test::TemporaryFolder folder;
};

TEST_F(WindowPack, SampleGoesWithoutIdentity)
{
    w.openSample();
    QDialog* dialog = asked();
    ASSERT_NE(dialog, nullptr);
    const auto boxes = dialog->findChildren<QCheckBox*>();
    ASSERT_EQ(boxes.size(), 3);
    EXPECT_TRUE(boxes[0]->isChecked()) << "identity stays here unless somebody wants it to go";
    boxes[0]->setChecked(false);
    EXPECT_FALSE(boxes[1]->isEnabled());
    boxes[0]->setChecked(true);
    OpenWindow::clickButton(dialog, QStringLiteral("Pack…"));
    const std::string archive = folder.file("case.zip");
    chooseFile(archive);
    const auto isThere = [&archive] { return QFile::exists(QString::fromStdString(archive)); };
    ASSERT_TRUE(test::waitFor(isThere));
    QProcess unpack;
    unpack.setWorkingDirectory(QString::fromStdString(folder.file("")));
    unpack.start(QStringLiteral("cmake"),
                 {QStringLiteral("-E"), QStringLiteral("tar"), QStringLiteral("xf"), QString::fromStdString(archive)});
    ASSERT_TRUE(unpack.waitForFinished(test::patienceMs));
    core::Messages warnings;
    const auto packed = io::loadCase(folder.file("case.angiopose"), warnings);
    ASSERT_TRUE(packed) << packed.error().message.text();
    EXPECT_TRUE(packed.value().title.empty());
}

TEST_F(WindowPack, StopLeavesNothing)
{
    w.openSample();
    QDialog* dialog = asked();
    ASSERT_NE(dialog, nullptr);
    OpenWindow::clickButton(dialog, QStringLiteral("Pack…"));
    chooseFile(folder.file("case.zip"));
    ASSERT_TRUE(test::waitFor([this] { return w.controller.isBusy(); }));
    emit w.window.strip().stopRequested();
    ASSERT_TRUE(test::waitFor([this] { return !w.controller.isBusy(); }));
    EXPECT_TRUE(QDir(QString::fromStdString(folder.file(""))).isEmpty(QDir::Files | QDir::Hidden));
}

TEST_F(WindowPack, NothingIsPackedWithoutACase)
{
    EXPECT_EQ(asked(), nullptr);
}

}   // namespace
}   // namespace angiopose::app
