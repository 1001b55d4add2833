#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"
#include "ui/panels/bottom_strip.h"

#include <gif_lib.h>
#include <QComboBox>
#include <QDir>
#include <QLabel>

namespace angiopose::app {
namespace {

using test::OpenWindow;

class WindowMovie : public ::testing::Test {
protected:
    WindowMovie()
    {
        settings::movieIsGif.write(false);
        settings::movieWidthPx.write(160);
        w.openSample();
    }

    QDialog* asked()
    {
        w.press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        const auto dialogs = w.dialogs("movieDialog");
        return dialogs.size() == 1 ? dialogs.front() : nullptr;
    }
    static QComboBox* parts(const QDialog* dialog)
    {
        return dialog->findChild<QComboBox*>(QStringLiteral("moviePart"));
    }
    static QString outcome(const QDialog* dialog)
    {
        return dialog->findChild<QLabel*>(QStringLiteral("movieOutcome"))->text();
    }
    static void choose(QComboBox* box, int index)
    {
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < index; ++i) {
            QTest::keyClick(box, Qt::Key_Down);
        }
    }
    bool waitForMovie()
    {
        return test::waitFor([this] { return !w.controller.movie().isRunning(); });
    }

    OpenWindow w;
    test::TemporaryFolder folder;
};

int pictureCount(const QString& path)
{
    int error = 0;
    GifFileType* gif = DGifOpenFileName(path.toStdString().c_str(), &error);
    const int count = gif != nullptr && DGifSlurp(gif) == GIF_OK ? gif->ImageCount : 0;
    DGifCloseFile(gif, &error);
    return count;
}

TEST_F(WindowMovie, OffersWhatThereIsAndTellsItsLength)
{
    QDialog* dialog = asked();
    ASSERT_TRUE(dialog);
    const bool isRun = w.current().shown().angiogram->frameCount() > 1;
    EXPECT_EQ(parts(dialog)->count(), isRun ? 2 : 1) << "no registration was made";
    choose(parts(dialog), parts(dialog)->count() - 1);
    EXPECT_TRUE(outcome(dialog).contains(QStringLiteral("120 frames, 6.0 s, 160 × 160 px")))
        << outcome(dialog).toStdString();
    OpenWindow::clickButton(dialog, QStringLiteral("Cancel"));

    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    dialog = asked();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(parts(dialog)->count(), isRun ? 3 : 2);
    choose(parts(dialog), isRun ? 1 : 0);
    EXPECT_TRUE(outcome(dialog).startsWith(QString::number(w.current().shown().result->history.size()) +
                                           QStringLiteral(" frames")))
        << outcome(dialog).toStdString();
}

TEST_F(WindowMovie, WritesWhatItOfferedAndRemembersHow)
{
    QDialog* dialog = asked();
    ASSERT_TRUE(dialog);
    choose(parts(dialog), parts(dialog)->count() - 1);
    choose(dialog->findChild<QComboBox*>(QStringLiteral("movieFormat")), 1);
    QTest::keyClick(dialog, Qt::Key_Return);
    const QString path = QString::fromStdString(folder.file("turn.gif"));
    w.saveAs(path);
    EXPECT_TRUE(waitForMovie());
    EXPECT_EQ(pictureCount(path), 120);
    EXPECT_TRUE(settings::movieIsGif.read());
}

TEST_F(WindowMovie, StopsWithoutLeavingAFile)
{
    settings::movieWidthPx.write(2048);
    QDialog* dialog = asked();
    ASSERT_TRUE(dialog);
    choose(parts(dialog), parts(dialog)->count() - 1);
    QTest::keyClick(dialog, Qt::Key_Return);
    QFileDialog* files = nullptr;
    ASSERT_TRUE(test::waitFor([&] { return (files = w.window.findChild<QFileDialog*>()) && files->isVisible(); }));
    files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))
        ->setText(QString::fromStdString(folder.file("turn.mp4")));
    QTest::mouseClick(files->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save), Qt::LeftButton);
    ASSERT_TRUE(test::waitFor([this] { return w.controller.movie().isRunning(); }));
    QPushButton* stop = nullptr;
    for (QPushButton* button : w.window.strip().findChildren<QPushButton*>()) {
        stop = button->isVisible() && button->text() == QStringLiteral("Stop") ? button : stop;
    }
    ASSERT_TRUE(stop);
    QTest::mouseClick(stop, Qt::LeftButton);
    EXPECT_TRUE(waitForMovie());
    const QDir there(QFileInfo(QString::fromStdString(folder.file("x"))).path());
    EXPECT_TRUE(there.entryList(QDir::Files | QDir::Hidden).isEmpty());
    settings::movieWidthPx.write(160);
}

TEST_F(WindowMovie, SaysWhatIsTooLargeBeforeItIsWritten)
{
    settings::movieWidthPx.write(8192);
    QDialog* dialog = asked();
    ASSERT_TRUE(dialog);
    EXPECT_TRUE(outcome(dialog).contains(QStringLiteral("or GIF"))) << outcome(dialog).toStdString();
    const auto exporting = dialog->findChildren<QPushButton*>();
    EXPECT_TRUE(std::ranges::any_of(exporting, [](const QPushButton* button) { return !button->isEnabled(); }));
    choose(dialog->findChild<QComboBox*>(QStringLiteral("movieFormat")), 1);
    EXPECT_TRUE(outcome(dialog).contains(QStringLiteral("8192 × 8192")) ||
                outcome(dialog).contains(QStringLiteral("8192 × ")))
        << outcome(dialog).toStdString();
    settings::movieWidthPx.write(160);
}

}   // namespace
}   // namespace angiopose::app
