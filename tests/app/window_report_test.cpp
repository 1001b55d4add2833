#include "app/preferences/settings.h"
#include "app/report/report_template.h"
#include "app/texts/overlay_image.h"
#include "core/case/registration_input.h"
#include "tests/app/open_window.h"
#include "tests/support/test_data.h"
#include "ui/dialogs/report_dialog.h"

#include <QCheckBox>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QTemporaryDir>

namespace angiopose::app {
namespace {

using test::OpenWindow;

class WindowReport : public ::testing::Test {
protected:
    ui::ReportDialog* asked()
    {
        w.window.actions()[ui::Command::ExportReport]->trigger();
        const auto dialogs = w.dialogs("reportDialog");
        EXPECT_EQ(dialogs.size(), 1);
        return qobject_cast<ui::ReportDialog*>(dialogs.front());
    }

    QByteArray written(const char* name, ui::Toggle identity = ui::Toggle::Off)
    {
        ui::ReportDialog* dialog = asked();
        auto* box = dialog->findChild<QCheckBox*>();
        EXPECT_FALSE(box->isChecked()) << "off by default, every time";
        if (identity == ui::Toggle::On) {
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        }
        OpenWindow::clickButton(dialog, QStringLiteral("Export…"));
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
    w.registerVessels();
    w.waitForJudgement();
    ASSERT_TRUE(w.current().shown().result);
    const QByteArray text = written("report.html");
    const QByteArray median = QByteArray::number(w.current().shown().result->metrics.medianMm, 'f', 2) + " mm";
    for (const QByteArray& wanted :
         {QByteArray("Not for clinical use"), median, QByteArray("SID"),
          QByteArray::fromStdString(w.current().shown().imageFile.sha256.substr(0, 16)), QByteArray("Signature")}) {
        EXPECT_TRUE(text.contains(wanted)) << wanted.toStdString();
    }
    const qsizetype from = text.lastIndexOf("base64,") + 7;   // after the marker
    const QImage picture = QImage::fromData(QByteArray::fromBase64(text.mid(from, text.indexOf('"', from) - from)));
    EXPECT_GT(
        picture.width(),
        2 * picture.height() * w.current().shown().angiogram->width() / w.current().shown().angiogram->height() - 1)
        << "before and after";
}

/// Figures of a registration apply to its frame only, not to another one.
TEST_F(WindowReport, TellsTheFiguresOfTheFrameItShows)
{
    w.openSample();
    w.registerVessels();
    w.waitForJudgement();
    const int foundIn = w.current().shown().frame;
    const double thereMm = w.current().shown().result->metrics.medianMm;
    w.press(Qt::Key_Up);
    ASSERT_NE(w.current().shown().frame, foundIn);
    ASSERT_TRUE(w.current().shown().result) << "kept: one step back it holds again";
    EXPECT_EQ(w.current().shown().result->provenance.frame, foundIn);
    w.waitForJudgement();
    const auto target = core::targetOf(w.current().shown());
    const auto here = core::evaluatePose(core::makeRegistrationInput(w.current(), target.value()).value(),
                                         w.current().shown().cameraFromPatient);
    const auto words = [](double mm) { return QByteArray::number(mm, 'f', 2) + " mm ("; };
    ASSERT_NE(words(here.value().metrics.medianMm), words(thereMm)) << "or this test could not fail";
    const QByteArray page = written("other.html");
    EXPECT_TRUE(page.contains(words(here.value().metrics.medianMm)));
    EXPECT_FALSE(page.contains(words(thereMm)));
    EXPECT_TRUE(page.contains(QStringLiteral("frame %1; image and values from frame %2")
                                  .arg(foundIn + 1)
                                  .arg(w.current().shown().frame + 1)
                                  .toUtf8()));
    const auto picture = drawOverlayVectors(w.current(), target.value());
    ASSERT_TRUE(picture);
    std::string reported;
    for (const ui::VectorText& text : picture.value().texts) {
        reported += text.text + "\n";
    }
    EXPECT_NE(reported.find("pose of frame " + std::to_string(foundIn + 1)), std::string::npos) << reported;
    EXPECT_EQ(reported.find("median"), std::string::npos) << reported;
}

TEST_F(WindowReport, CallsTheInitialPoseSo)
{
    w.openSample();
    w.waitForJudgement();
    EXPECT_TRUE(written("start.html").contains("none: this is the initial pose"));
}

TEST_F(WindowReport, IsAPdfAndJudgesAPoseSetByHand)
{
    w.openSample();
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    ASSERT_FALSE(w.current().shown().result);
    EXPECT_TRUE(written("moved.html").contains("pose set manually"));
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
    ASSERT_TRUE(test::waitFor([this] { return w.current().views.size() == 2; }));
    const QByteArray page = written("two.html");
    EXPECT_EQ(page.count("base64,"), 3) << "an overlay each, and the mark";
    EXPECT_TRUE(page.contains("1 · ")) << "numbered as the strip numbers them";
    EXPECT_TRUE(page.contains("2 · "));
    EXPECT_EQ(page.count("Median distance"), 2);
    EXPECT_EQ(page.count("page-break-before"), 1) << "a picture stays with what stands above it";
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
    EXPECT_TRUE(written("named.html", ui::Toggle::On).contains("fantom as"));
}

class WindowReportTemplate : public WindowReport {
protected:
    void SetUp() override
    {
        QImage logo(40, 20, QImage::Format_RGB32);
        logo.fill(QColor(200, 30, 60));
        ASSERT_TRUE(logo.save(folder.filePath(QStringLiteral("logo.png"))));
        w.openSample();
        w.waitForJudgement();
    }
    void TearDown() override { settings::reportTemplate.write({}); }

    /// Chooses a template in the dialog; the next report dialog starts with it.
    void choose(const QByteArray& html)
    {
        const QString path = folder.filePath(QStringLiteral("letter.html"));
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(html);
        file.close();
        ui::ReportDialog* dialog = asked();
        OpenWindow::clickButton(dialog, QStringLiteral("Choose…"));
        auto* files = dialog->findChild<QFileDialog*>();
        ASSERT_TRUE(files);
        files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
        QTest::mouseClick(files->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open), Qt::LeftButton);
        EXPECT_EQ(dialog->options().templatePath, path);
        settings::reportTemplate.write(path);
        dialog->reject();
        QTest::qWait(50);
    }
    const QByteArray whole = "<html><body>{{notice}}{{warnings}}{{ views }}</body></html>";
};

TEST_F(WindowReportTemplate, PrintsItsWordsAndItsLogo)
{
    choose(
        "<html><body><!-- {{nothing}} --><img src=\"logo.png\" width=\"80\"/>Ward 7: {{title}}"
        "{{notice}}{{warnings}}{{views}}<i>{{program}}</i></body></html>");
    const QByteArray page = written("own.html");
    EXPECT_TRUE(page.contains("Ward 7: Sample case"));
    EXPECT_TRUE(page.contains("Not for clinical use"));
    EXPECT_TRUE(page.contains("Median distance"));
    EXPECT_TRUE(page.contains("<i>AngioPose "));
    EXPECT_FALSE(page.contains("{{"));
    EXPECT_FALSE(page.contains("Signature")) << "not asked for";
    const qsizetype from = page.indexOf("base64,") + 7;
    const QImage logo = QImage::fromData(QByteArray::fromBase64(page.mid(from, page.indexOf('"', from) - from)));
    EXPECT_EQ(logo.size(), QSize(40, 20));
    EXPECT_EQ(logo.pixelColor(20, 10), QColor(200, 30, 60));
    EXPECT_TRUE(written("own.pdf").startsWith("%PDF"));
}

TEST_F(WindowReportTemplate, WhatACaseIsCalledFillsInNothing)
{
    core::Case renamed = w.current();
    renamed.title = "{{views}} <b>";
    w.controller.document().replace(renamed, {});
    w.waitForJudgement();
    choose(whole + "{{title}}");
    EXPECT_TRUE(written("own.html").contains("</body></html>{{views}} &lt;b&gt;"));
}

TEST_F(WindowReportTemplate, TheBuiltInOneIsSavedToBeChanged)
{
    ui::ReportDialog* dialog = asked();
    OpenWindow::clickButton(dialog, QStringLiteral("Save a copy…"));
    const QString path = folder.filePath(QStringLiteral("mine.html"));
    w.saveAs(path);
    dialog->close();
    const auto own = readReportTemplate(path);
    ASSERT_TRUE(own);
    EXPECT_EQ(own.value().html, readReportTemplate({}).value().html);
}

TEST_F(WindowReportTemplate, WhatMustBeSaidCannotBeLeftOut)
{
    const auto reasonOf = [this](const QByteArray& html) {
        const QString path = folder.filePath(QStringLiteral("bad.html"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(html);
        file.close();
        const auto page = readReportTemplate(path);
        return page ? std::string() : page.error().message.text();
    };
    EXPECT_EQ(reasonOf(whole), "");
    EXPECT_NE(reasonOf("{{warnings}}{{views}}").find("{{notice}}"), std::string::npos);
    EXPECT_NE(reasonOf("{{notice}}{{views}}").find("{{warnings}}"), std::string::npos);
    EXPECT_NE(reasonOf("{{notice}}{{warnings}}<!-- {{views}} -->").find("{{views}}"), std::string::npos);
    EXPECT_NE(reasonOf("{{notice}}{{warnings}}<!-- {{views}}").find("{{views}}"), std::string::npos);
    EXPECT_NE(reasonOf(whole + "{{patent}}").find("{{patent}}"), std::string::npos);
    EXPECT_NE(reasonOf(whole + "{{picture 0}}").find("{{picture 0}}"), std::string::npos);
    EXPECT_NE(reasonOf(whole + "\xff\xfe").find("UTF-8"), std::string::npos);
    EXPECT_NE(reasonOf(whole + QByteArray(2 << 20, ' ')).find("1 MB"), std::string::npos);
    for (const char* elsewhere : {"http://example.com/a.png", "/etc/passwd", "../logo.png", "bad.html", "absent.png"}) {
        EXPECT_NE(reasonOf(whole + "<img src='" + elsewhere + "'>").find(elsewhere), std::string::npos) << elsewhere;
    }
    EXPECT_NE(reasonOf(whole + "<img src=//example.com/a.png>").find("//example.com"), std::string::npos);
    for (const char* fetching : {"<script>1</script>", "< LINK href='a.css'>", "<p style='background:url(a.png)'>"}) {
        EXPECT_NE(reasonOf(whole + fetching).find("load or run"), std::string::npos) << fetching;
    }
    EXPECT_EQ(reasonOf(whole + "<img src='logo.png'>"), "");
    EXPECT_NE(readReportTemplate(folder.filePath(QStringLiteral("gone.html"))).error().message.text().find("gone.html"),
              std::string::npos);
}

TEST_F(WindowReportTemplate, AReportWithoutItsTemplateIsNotWrittenAndSaysWhy)
{
    settings::reportTemplate.write(folder.filePath(QStringLiteral("gone.html")));
    OpenWindow::clickButton(asked(), QStringLiteral("Export…"));
    const QString path = folder.filePath(QStringLiteral("report.html"));
    QFileDialog* files = nullptr;
    ASSERT_TRUE(test::waitFor([&] { return (files = w.window.findChild<QFileDialog*>()) != nullptr; }));
    files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
    QTest::mouseClick(files->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save), Qt::LeftButton);
    ASSERT_TRUE(test::waitFor([this] { return !w.dialogs("messageDialog").isEmpty(); }));
    bool isNamed = false;
    for (const QLabel* label : w.dialogs("messageDialog").front()->findChildren<QLabel*>()) {
        isNamed |= label->text().contains(QStringLiteral("gone.html"));
    }
    EXPECT_TRUE(isNamed);
    EXPECT_FALSE(QFile::exists(path));
}

}   // namespace
}   // namespace angiopose::app
