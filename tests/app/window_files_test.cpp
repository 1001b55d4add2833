#include "app/texts/overlay_image.h"
#include "app/words/view_words.h"
#include "tests/app/open_window.h"
#include "tests/support/test_data.h"
#include "ui/words/language.h"

#include "app/document/edit_case.h"
#include "app/preferences/settings.h"

#include <QDirIterator>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

QString dataPath(const char* relative)
{
    return QString::fromStdString(test::dataFile(relative).string());
}

TEST(WindowFiles, MakeACaseOfTreeAndImageDroppedTogether)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A/IM4.dcm");
    OpenWindow w;

    w.drop({dataPath("coronary-phantom-xa/views-A/IM4.dcm"), dataPath("coronary-phantom-xa/tree/Centerlines.vtk")});

    ASSERT_TRUE(w.current().vessels.tree && w.current().shown().angiogram);
    EXPECT_EQ(w.current().vessels.tree->branches.size(), 11U);
    EXPECT_TRUE(w.controller.pose().currentOffset());
    EXPECT_TRUE(w.controller.document().isModified());
    EXPECT_TRUE(w.dialogs("messageDialog").isEmpty());
}

TEST(WindowFiles, JoinTheOpenCaseOneByOneAndCanBeUndone)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A/IM4.dcm");
    OpenWindow w;

    w.drop({dataPath("coronary-phantom-xa/tree/Centerlines.vtk")});
    EXPECT_TRUE(w.current().vessels.tree && !w.current().shown().angiogram);
    w.drop({dataPath("coronary-phantom-xa/views-A/IM4.dcm")});

    ASSERT_TRUE(w.current().shown().angiogram);
    EXPECT_TRUE(w.controller.registration().notReadyReason().isEmpty());
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(w.current().shown().angiogram);
    w.press(Qt::Key_Y, Qt::ControlModifier);
    EXPECT_TRUE(w.current().shown().angiogram);
}

TEST(WindowFiles, SaveAndReopenGiveTheSameCase)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("again.angiopose"));
    core::Case saved;
    {
        SampleWindow w;
        w.controller.branches().setAuxiliary({w.current().vessels.tree->branches[1].id});
        w.controller.branches().toggleExcluded({w.current().vessels.tree->branches[3].id});
        w.press(Qt::Key_N);
        w.press(Qt::Key_Right);
        w.press(Qt::Key_Down, Qt::AltModifier);
        EXPECT_TRUE(w.controller.document().isModified());
        EXPECT_TRUE(w.window.windowTitle().contains(QLatin1Char('*')));
        bool isSaved = false;
        w.controller.saveController().saveTo(path, [&isSaved] { isSaved = true; });
        EXPECT_FALSE(isSaved);   // a worker saves
        ASSERT_TRUE(test::waitFor([&isSaved] { return isSaved; }));
        EXPECT_FALSE(w.controller.document().isModified());
        EXPECT_FALSE(w.window.windowTitle().contains(QLatin1Char('*')));
        saved = w.current();
    }
    OpenWindow w;
    w.drop({path});

    EXPECT_EQ(w.current().title, saved.title);
    EXPECT_EQ(w.current().shown().frame, saved.shown().frame);
    EXPECT_EQ(w.current().vessels.auxiliaryBranchIds, saved.vessels.auxiliaryBranchIds);
    EXPECT_EQ(w.current().vessels.excludedBranchIds, saved.vessels.excludedBranchIds);
    EXPECT_EQ(w.current().options, saved.options);
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, saved.shown().cameraFromPatient), 0.0);
    EXPECT_EQ(test::distance(*w.current().shown().initialCameraFromPatient, *saved.shown().initialCameraFromPatient),
              0.0);
}

TEST(WindowFiles, AskBeforeUnsavedChangesAreReplaced)
{
    SampleWindow w;
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    const core::RigidTransform edited = w.current().shown().cameraFromPatient;

    w.openSample();
    ASSERT_EQ(w.dialogs("questionDialog").size(), 1);
    OpenWindow::clickButton(w.dialogs("questionDialog").front(), QStringLiteral("Keep current case"));
    EXPECT_EQ(test::distance(w.current().shown().cameraFromPatient, edited), 0.0);

    w.openSample();
    OpenWindow::clickButton(w.dialogs("questionDialog").front(), QStringLiteral("Discard changes"));
    EXPECT_GT(test::distance(w.current().shown().cameraFromPatient, edited), 0.5);
}

TEST(WindowFiles, LeaveWhatCannotBeSavedWhereTheQuestionIsDismissed)
{
    SampleWindow w;
    core::Case image;
    image.shown().angiogram = w.current().shown().angiogram;
    w.controller.document().replace(image, {});
    core::RegistrationOptions options = w.current().options;
    options.maxIterations = 7;
    w.controller.document().push(std::make_unique<ChangeOptions>(
        w.controller.document(), ChangeOptions::Values{options}, [] { return QStringLiteral("Change"); }));

    w.window.close();
    ASSERT_EQ(w.dialogs("closeQuestion").size(), 1);
    QTest::keyClick(w.dialogs("closeQuestion").front(), Qt::Key_Escape);
    QTest::qWait(200);
    EXPECT_TRUE(w.window.isVisible());
    EXPECT_EQ(w.current().options.maxIterations, 7);
}

TEST(WindowFiles, CloseTheCaseAndKeepTheWindow)
{
    SampleWindow w;
    const QImage image = w.window.angiogramView().grab().toImage();
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    QTest::keyClick(&w.window, Qt::Key_W, Qt::ControlModifier);
    ASSERT_EQ(w.dialogs("closeQuestion").size(), 1);
    OpenWindow::clickButton(w.dialogs("closeQuestion").front(), QStringLiteral("Close without saving"));
    EXPECT_TRUE(test::waitFor([&w] { return w.controller.document().isEmpty(); }));

    EXPECT_TRUE(w.window.isVisible());
    EXPECT_TRUE(w.window.welcome().isVisible());
    EXPECT_TRUE(w.controller.document().path().isEmpty());
    EXPECT_FALSE(w.controller.document().isModified());
    EXPECT_NE(w.window.angiogramView().grab().toImage(), image);   // no remnant of the image behind the welcome page
    w.openSample();   // opens a separate case
    EXPECT_FALSE(w.controller.document().isModified());
}

TEST(WindowFiles, CloseWithoutAskingWhenNothingChanged)
{
    SampleWindow w;

    w.window.close();

    EXPECT_TRUE(w.dialogs("closeQuestion").isEmpty());
    EXPECT_TRUE(test::waitFor([&w] { return !w.window.isVisible(); }));
}

TEST(WindowFiles, WriteAnOverlayWithItsProvenance)
{
    const QTemporaryDir folder;
    SampleWindow w;
    const QString path = folder.filePath(QStringLiteral("overlay.png"));

    QSignalSpy exported(&w.controller.exportController(), &ExportController::exported);
    w.controller.exportController().exportOverlay({600, ui::Toggle::On, ui::Toggle::Off}, path);
    EXPECT_TRUE(exported.isEmpty());   // a worker exports
    ASSERT_TRUE(exported.wait(test::patienceMs));

    const QImage picture(path);
    EXPECT_EQ(picture.width(), 600);
    EXPECT_TRUE(picture.textKeys().contains(QStringLiteral("cameraFromPatient")));
    EXPECT_TRUE(picture.text(QStringLiteral("Disclaimer")).contains(QStringLiteral("clinical")));
}

/// Answers the questions with "replace": the sample has vessels and an angiogram, so another angiogram could be added.
void takeInsteadOfWhatIsOpen(OpenWindow& w)
{
    for (QDialog* asked : w.dialogs("unitQuestion")) {
        const QList<QPushButton*> buttons = asked->findChildren<QPushButton*>();
        const auto millimeters = std::ranges::find_if(
            buttons, [](const QPushButton* button) { return button->text().startsWith(QLatin1String("mm: ")); });
        ASSERT_NE(millimeters, buttons.end());
        QTest::mouseClick(*millimeters, Qt::LeftButton);
        EXPECT_TRUE(test::waitFor([&w] { return !w.controller.isLoading(); }));
    }
    for (const auto& [question, verb] : {std::pair{"scanQuestion", QStringLiteral("Trace this scan")},
                                         std::pair{"viewQuestion", QStringLiteral("Replace the angiogram")},
                                         std::pair{"patientQuestion", QStringLiteral("Open anyway")}}) {
        for (QDialog* asked : w.dialogs(question)) {
            OpenWindow::clickButton(asked, verb);
            EXPECT_TRUE(test::waitFor([&w] { return !w.controller.isLoading(); }));
        }
    }
}

TEST(WindowFiles, SpeakTheLanguageOfTheWindowInAnOverlay)
{
    SampleWindow w;
    const auto pictureIn = [&w](const char* windowLanguage, ui::CornerTexts (*texts)(const CornerLines&)) {
        ui::applyLanguage(QString::fromLatin1(windowLanguage));
        const auto picture = drawOverlay(w.current(), {}, {400, OverlayColoring::Branches, Identity::Hidden, texts});
        ui::applyLanguage(QStringLiteral("en"));
        return picture ? picture.value().rgb : std::vector<std::uint8_t>{};
    };
    const auto english = pictureIn("en", windowTexts);
    ASSERT_FALSE(english.empty());
    EXPECT_NE(pictureIn("de", windowTexts), english);
    EXPECT_NE(pictureIn("zh_CN", windowTexts), pictureIn("de", windowTexts));
    EXPECT_EQ(pictureIn("de", englishTexts), english);
}

std::string openDialogs(OpenWindow& w)
{
    std::string names;
    for (const QDialog* dialog : w.window.findChildren<QDialog*>()) {
        names += dialog->isVisible() ? " " + dialog->objectName().toStdString() : "";
    }
    return names;
}

/// Every file dropped on the window is either loaded or rejected with one message, and the open case survives a
/// rejection.
class WindowBadFiles : public ::testing::TestWithParam<const char*> {};

TEST_P(WindowBadFiles, LoadOrAreRefusedByOneMessage)
{
    ANGIOPOSE_NEEDS_DATA(GetParam());
    OpenWindow w;
    bool needsSample = true;
    QDirIterator files(dataPath(GetParam()), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString path = files.next();
        if (needsSample) {
            w.controller.document().replace({}, {});
            w.openSample();
        }
        const auto treeBefore = w.current().vessels.tree;
        const auto imageBefore = w.current().shown().angiogram;

        w.drop({path});
        const auto isUntouched = [&] {
            return w.current().vessels.tree == treeBefore && w.current().shown().angiogram == imageBefore &&
                   !w.current().shown().target.centerline;
        };
        const auto isSettled = [&] {
            takeInsteadOfWhatIsOpen(w);   // a question may appear late on a busy machine
            return !w.controller.isBusy() && (!isUntouched() || !w.dialogs("messageDialog").empty());
        };
        EXPECT_TRUE(test::waitFor(isSettled)) << path.toStdString() << openDialogs(w);
        const auto messages = w.dialogs("messageDialog");
        needsSample = !isUntouched();
        EXPECT_EQ(messages.size(), needsSample ? 0 : 1) << path.toStdString();
        for (QDialog* message : messages) {
            message->close();
        }
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

INSTANTIATE_TEST_SUITE_P(Exotic, WindowBadFiles,
                         ::testing::Values("exotic-dicom", "exotic-lfs-pointers", "exotic-mesh", "exotic-nifti",
                                           "exotic-nrrd"));

}   // namespace
}   // namespace angiopose::app
