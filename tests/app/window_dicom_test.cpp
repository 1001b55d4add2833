#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"
#include "ui/panels/bottom_strip.h"

#include <QCheckBox>
#include <QLabel>

namespace angiopose::app {
namespace {

using test::OpenWindow;

class WindowDicom : public ::testing::Test {
protected:
    QDialog* asked()
    {
        w.window.actions()[ui::Command::ExportDicom]->trigger();
        const auto dialogs = w.dialogs("dicomDialog");
        return dialogs.size() == 1 ? dialogs.front() : nullptr;
    }

    void chooseFolder()
    {
        QFileDialog* files = nullptr;
        const auto isThere = [&] { return (files = w.window.findChild<QFileDialog*>()) && files->isVisible(); };
        ASSERT_TRUE(test::waitFor(isThere));
        files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(QString::fromStdString(folder.file("")));
        QTest::mouseClick(files->findChild<QDialogButtonBox*>()->buttons().front(), Qt::LeftButton);
    }

    bool waitFor(const char* name)
    {
        const QString path = QString::fromStdString(folder.file(name));
        return test::waitFor([&path] { return QFile::exists(path); });
    }

    OpenWindow w;
    test::TemporaryFolder folder;
};

TEST_F(WindowDicom, WritesWhatIsChosen)
{
    w.openSample();
    QDialog* dialog = asked();
    ASSERT_NE(dialog, nullptr);
    const auto boxes = dialog->findChildren<QCheckBox*>();
    ASSERT_EQ(boxes.size(), 8);
    EXPECT_FALSE(boxes[5]->isEnabled()) << "the sample has no scan";
    EXPECT_FALSE(boxes[7]->isChecked()) << "identity is off, every time";
    boxes[1]->setChecked(false);   // overlay images of a whole run take long
    OpenWindow::clickButton(dialog, QStringLiteral("Export…"));
    chooseFolder();
    EXPECT_TRUE(waitFor("camera.json"));   // the last file to be written
    for (const char* name : {"overlay.dcm", "report.dcm", "presentation-state.dcm", "registration.dcm"}) {
        EXPECT_TRUE(QFile::exists(QString::fromStdString(folder.file(name)))) << name;
    }
    EXPECT_FALSE(QFile::exists(QString::fromStdString(folder.file("overlay-run.dcm"))));
    EXPECT_NE(test::readText(folder.file("report.dcm")).find("%PDF-"), std::string::npos);
    const auto said = [this] {
        for (const QLabel* label : w.window.findChildren<QLabel*>()) {
            if (label->text().contains(QStringLiteral("DICOM objects written"))) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(test::waitFor(said));
}

TEST_F(WindowDicom, ExportsNothingWithoutAChoiceOrACase)
{
    EXPECT_EQ(asked(), nullptr) << "there is no case";
    for (QDialog* problem : w.window.findChildren<QDialog*>()) {
        problem->close();
    }
    w.openSample();
    QDialog* dialog = asked();
    ASSERT_NE(dialog, nullptr);
    for (QCheckBox* box : dialog->findChildren<QCheckBox*>()) {
        box->setChecked(false);
    }
    for (const QPushButton* button : dialog->findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Export…")) {
            EXPECT_FALSE(button->isEnabled());
        }
    }
}

}   // namespace
}   // namespace angiopose::app
