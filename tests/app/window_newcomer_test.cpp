#include "tests/app/open_window.h"
#include "tests/io/series/ct_phantom.h"
#include "tests/support/forked_vessel.h"

#include "app/preferences/settings.h"
#include "ui/panels/step_button.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QTemporaryDir>

namespace angiopose::app {
namespace {

/// Fixture: a first-time user who only clicks; counts every click and every drop.
class Newcomer : public ::testing::Test {
protected:
    void SetUp() override
    {
        settings::noticeAccepted.write(false);
        settings::isTourCompleted.write(false);
        settings::lastFolder.write(folder.path());
        w.controller.begin({});
    }
    void TearDown() override
    {
        settings::lastFolder.write({});
        settings::saveFolder.write({});
    }

    /// Clicks the middle of the widget after checking that nothing covers it and no modal dialog would receive the
    /// click instead.
    void click(QWidget* widget)
    {
        ASSERT_TRUE(widget && widget->isVisible() && widget->isEnabled());
        const QWidget* modal = QApplication::activeModalWidget();
        ASSERT_TRUE(!modal || modal == widget->window()) << "a dialog is in front: " << qPrintable(modal->objectName());
        const QWidget* hit = widget->window()->childAt(widget->mapTo(widget->window(), widget->rect().center()));
        ASSERT_TRUE(hit == widget || widget->isAncestorOf(hit)) << "covered by " << hit->metaObject()->className();
        QTest::mouseClick(widget, Qt::LeftButton);
        ++clicks;
    }

    template <class Button = QPushButton>
    static Button* buttonCalled(const QWidget* parent, const char* text)
    {
        for (Button* button : parent->findChildren<Button*>()) {
            if (button->text() == QString::fromUtf8(text) && button->isVisible()) {
                return button;
            }
        }
        return nullptr;
    }

    void acceptNotice()
    {
        ASSERT_EQ(w.dialogs("noticeDialog").size(), 1);
        click(buttonCalled(w.dialogs("noticeDialog").front(), "I understand"));
    }

    void openAllTheSame()
    {
        ASSERT_TRUE(test::waitFor([this] { return w.dialogs("patientQuestion").size() == 1; }));
        click(buttonCalled(w.dialogs("patientQuestion").front(), "Open anyway"));
    }

    void drop(const QString& path)
    {
        w.drop({path});
        ++clicks;
    }

    void registerAndExport()
    {
        w.waitForJudgement();
        click(w.window.registration().registerButton());
        w.waitForRun();
        click(buttonCalled<ui::StepButton>(&w.window.steps(), "Export"));
        ui::ExportDialog* choice = nullptr;
        ASSERT_TRUE(test::waitFor([&] { return (choice = w.window.findChild<ui::ExportDialog*>()); }));
        click(buttonCalled(choice, "Export…"));
        QFileDialog* files = nullptr;
        ASSERT_TRUE(test::waitFor([&] { return (files = w.window.findChild<QFileDialog*>()) && files->isVisible(); }));
        click(files->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save));
        ASSERT_TRUE(test::waitFor([this] { return !pictures().isEmpty(); }));
    }

    QStringList pictures() const { return QDir(folder.path()).entryList({QStringLiteral("*.png")}); }

    QTemporaryDir folder;
    test::OpenWindow w;
    int clicks = 0;
};

TEST_F(Newcomer, ReachesAnOverlayOfTheSampleInSixClicks)
{
    acceptNotice();
    click(buttonCalled(&w.window.welcome(), "Open the sample case"));
    ASSERT_TRUE(test::waitFor([this] { return w.current().shown().angiogram != nullptr; }));
    registerAndExport();
    EXPECT_LE(clicks, 6);
}

TEST_F(Newcomer, ReachesAnOverlayOfADicomFolderAndARunInTwelve)
{
    const test::TemporaryFolder study;
    test::writeShuffled(study, test::allSlices(test::forkScan()));
    const auto sample = writeSampleCase();
    ASSERT_TRUE(sample);
    acceptNotice();
    drop(QString::fromStdString(study.file("")));
    ASSERT_TRUE(test::waitFor([this] { return w.current().vessels.tree != nullptr; }));
    drop(QFileInfo(sample.value()).dir().filePath(QStringLiteral("run.dcm")));
    openAllTheSame();   // the scan and the sample's run are of different patients
    ASSERT_TRUE(test::waitFor([this] { return w.current().shown().angiogram != nullptr; }));
    registerAndExport();
    EXPECT_LE(clicks, 12);
}

TEST_F(Newcomer, IsShownTheTourOnceAndOnlyOnce)
{
    acceptNotice();
    EXPECT_TRUE(w.window.findChild<QWidget*>(QStringLiteral("tour")));
    EXPECT_TRUE(settings::isTourCompleted.read());
}

TEST_F(Newcomer, IsAskedForWhatAStepLacks)
{
    acceptNotice();
    click(buttonCalled<ui::StepButton>(&w.window.steps(), "Angiogram"));
    auto* files = w.window.findChild<QFileDialog*>();
    ASSERT_TRUE(files);
    files->reject();
}

}   // namespace
}   // namespace angiopose::app
