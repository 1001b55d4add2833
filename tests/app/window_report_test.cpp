#include "tests/app/open_window.h"
#include "tests/support/test_data.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Reports written through the menu and the file dialog.
class WindowReport : public ::testing::Test {
protected:
    QByteArray written(const char* name, const char* answer = "Without identity")
    {
        w.window.actions()[ui::Command::ExportReport]->trigger();
        const auto questions = w.dialogs("identityQuestion");
        EXPECT_EQ(questions.size(), 1);
        OpenWindow::clickButton(questions.front(), QString::fromUtf8(answer));
        const QString path = folder.filePath(QString::fromLatin1(name));
        w.saveAs(path);
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }

    const QTemporaryDir folder;
    OpenWindow w;
};

TEST_F(WindowReport, HoldsPictureResultGeometryAndInputs)
{
    w.openSample();
    w.press(Qt::Key_R);
    w.waitForRun();
    w.waitForJudgement();
    ASSERT_TRUE(w.current().shown().result);
    const QByteArray text = written("report.html");
    const QByteArray median = QByteArray::number(w.current().shown().result->metrics.medianMm, 'f', 2) + " mm";
    for (const QByteArray& wanted :
         {QByteArray("Not for clinical use"), median, QByteArray("SID"),
          QByteArray::fromStdString(w.current().shown().imageFile.sha256.substr(0, 16)), QByteArray("Signature")}) {
        EXPECT_TRUE(text.contains(wanted)) << wanted.toStdString();
    }
    const qsizetype from = text.lastIndexOf("base64,") + 7;   // behind the mark
    const QImage picture = QImage::fromData(QByteArray::fromBase64(text.mid(from, text.indexOf('"', from) - from)));
    EXPECT_GT(
        picture.width(),
        2 * picture.height() * w.current().shown().angiogram->width() / w.current().shown().angiogram->height() - 1)
        << "before and after";
}

TEST_F(WindowReport, IsAPdfAndJudgesAPoseSetByHand)
{
    w.openSample();
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    ASSERT_FALSE(w.current().shown().result);
    const QByteArray page = written("report.pdf");
    EXPECT_TRUE(page.startsWith("%PDF"));
    EXPECT_GT(page.size(), 20000) << "the pictures are in it";
}

TEST_F(WindowReport, HasAPartForEveryViewInTheTypefaceOfTheWindow)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases/IM4.angiopose");
    w.drop({QString::fromStdString(test::dataFile("coronary-phantom-xa/cases/IM4.angiopose").string())});
    w.waitForJudgement();
    w.drop({QString::fromStdString(test::dataFile("coronary-phantom-xa/views-A/IM3.dcm").string())});
    OpenWindow::clickButton(w.dialogs("viewQuestion").front(), QStringLiteral("Add as a view"));
    ASSERT_TRUE(QTest::qWaitFor([this] { return w.current().views.size() == 2; }, test::patienceMs));
    const QByteArray page = written("two.html");
    EXPECT_EQ(page.count("base64,"), 3) << "an overlay each, and the mark";
    EXPECT_TRUE(page.contains("1 · ")) << "numbered as the strip numbers them";
    EXPECT_TRUE(page.contains("2 · "));
    EXPECT_EQ(page.count("Median distance"), 2);
    EXPECT_TRUE(page.contains(QApplication::font().families().front().toUtf8()));
}

TEST_F(WindowReport, NamesThePatientOnlyWhereThatIsWanted)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases/IM4.angiopose");
    w.drop({QString::fromStdString(test::dataFile("coronary-phantom-xa/cases/IM4.angiopose").string())});
    w.waitForJudgement();
    const QByteArray hidden = written("hidden.html");
    EXPECT_FALSE(hidden.contains("fantom as"));
    EXPECT_TRUE(hidden.contains("identity hidden"));
    EXPECT_TRUE(written("named.html", "With identity").contains("fantom as"));
}

}   // namespace
}   // namespace angiopose::app
