#include "core/simulation/simulate_cta.h"
#include "tests/app/open_window.h"
#include "tests/io/study/study_disc.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/study_browser.h"
#include "ui/dialogs/study_list.h"
#include "ui/panels/registration_panel.h"

#include <QMenu>
#include <QMenuBar>
#include <QTreeWidgetItemIterator>

#include <filesystem>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Counts mouse clicks. File names are typed, which does not count as a click.
class Hand {
public:
    explicit Hand(OpenWindow& window) : w(window) {}

    void click(QWidget* widget, QPoint place = {})
    {
        ASSERT_TRUE(widget && widget->isVisible() && widget->isEnabled());
        ++clicks;
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
    }

    void clickText(QWidget& within, const QString& text)
    {
        for (QPushButton* button : within.findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text().startsWith(text)) {
                click(button);
                return;
            }
        }
        FAIL() << "no button " << text.toStdString();
    }

    /// Two clicks: the menu and the item in it.
    void chooseInMenu(ui::Command command)
    {
        QAction* wanted = w.window.actions()[command];
        auto* bar = w.window.findChild<QMenuBar*>();
        for (QAction* title : bar->actions()) {
            if (title->menu() && title->menu()->actions().contains(wanted)) {
                click(bar, bar->actionGeometry(title).center());
                ASSERT_TRUE(test::waitFor([&] { return title->menu()->isVisible(); }));
                click(title->menu(), title->menu()->actionGeometry(wanted).center());
                return;
            }
        }
        FAIL() << "the command is in no menu";
    }

    template <class Dialog>
    Dialog* dialog()
    {
        Dialog* found = nullptr;
        EXPECT_TRUE(
            test::waitFor([&] { return (found = w.window.findChild<Dialog*>()) != nullptr && found->isVisible(); }));
        return found;
    }

    void answerFiles(const QString& path, QDialogButtonBox::StandardButton button)
    {
        auto* files = dialog<QFileDialog>();
        ASSERT_TRUE(files);
        files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
        click(files->findChild<QDialogButtonBox*>()->button(button));
    }

    void exportOverlay(const QString& path)
    {
        chooseInMenu(ui::Command::ExportOverlay);
        auto* choice = dialog<ui::ExportDialog>();
        ASSERT_TRUE(choice);
        clickText(*choice, QStringLiteral("Export"));
        answerFiles(path, QDialogButtonBox::Save);
        EXPECT_TRUE(test::waitFor([&path] { return QFile::exists(path); }));
    }

    void registerNow()
    {
        QPushButton* button = w.window.registration().registerButton();
        ASSERT_TRUE(test::waitFor([&] { return button->isEnabled(); }));
        click(button);
        w.waitForRun();
    }

    OpenWindow& w;
    int clicks = 0;
};

TEST(WindowClicks, FromTheSampleToAnExportedOverlayInSix)
{
    const test::TemporaryFolder folder;
    OpenWindow w;
    Hand hand(w);

    hand.clickText(w.window.welcome(), QStringLiteral("Open the sample case"));
    ASSERT_TRUE(test::waitFor([&] { return w.current().shown().angiogram != nullptr; }));
    hand.registerNow();
    ASSERT_TRUE(w.current().shown().result);
    hand.exportOverlay(QString::fromStdString(folder.file("overlay.png")));

    EXPECT_LE(hand.clicks, 6);
    EXPECT_GT(QImage(QString::fromStdString(folder.file("overlay.png"))).width(), 500);
}

/// Mean distance in px between the tree at its true pose and at the pose found.
double offPx(const core::VesselTree& tree, const core::SimulatedCase& truth, const core::RigidTransform& found)
{
    double sum = 0.0;
    int count = 0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const auto there = core::project(truth.camera, truth.trueCameraFromPatient * point);
            const auto here = core::project(truth.camera, found * point);
            if (there && here) {
                sum += (*there - *here).norm();
                ++count;
            }
        }
    }
    return count > 0 ? sum / count : 1e9;
}

/// Writes a disc with a CT angiogram of 120 slices, a run of the same vessels, and a DICOMDIR that lists both.
core::SimulatedCase writeSimulatedDisc(const test::TemporaryFolder& folder)
{
    const core::TreeOptions tree{.branchCount = 8, .extentMm = 84.0, .rootRadiusMm = 4.0};
    const core::SimulatedCta cta =
        core::simulateCta(3, tree, {.size = {128, 128, 128}, .spacingMm = {1.0, 1.0, 1.0}, .calcificationCount = 4});
    core::DsaOptions dsa;
    dsa.missingBranchShare = dsa.extraBranchShare = 0.0;
    dsa.shutterProbability = 0.0;
    core::SimulatedCase seen = core::simulateCase(3, tree, dsa);
    std::vector<std::string> names;
    const std::string sopClass = "1.2.840.10008.5.1.4.1.1.2";
    for (const test::CtSlice& slice : test::allSlices(cta.volume)) {
        names.push_back("CT/IM" + std::to_string(slice.instanceNumber));
        test::DicomBytes head;
        head.text(0x0008, 0x0016, "UI", sopClass);
        folder.write(names.back(),
                     test::withMeta(head.content() + test::ctSlice(slice).substr(132), sopClass, slice.sopInstanceUid));
    }
    core::Angiogram run = seen.angiogram;
    run.identity = test::spotRun().identity;
    folder.write("XA/FILL", "");
    EXPECT_TRUE(io::writeAngiogram(run, folder.file("XA/RUN1.dcm")));
    std::filesystem::rename(folder.file("XA/RUN1.dcm"), folder.file("XA/RUN1"));
    std::filesystem::remove(folder.file("XA/FILL"));
    names.emplace_back("XA/RUN1");
    test::writeDicomdir(folder.file(""), names);
    return seen;
}

TEST(WindowClicks, FromADiscToARegisteredCaseInTwelve)
{
    const test::TemporaryFolder folder;
    const core::SimulatedCase truth = writeSimulatedDisc(folder);
    OpenWindow w;
    Hand hand(w);

    hand.clickText(w.window.welcome(), QStringLiteral("Open DICOM folder/CD"));
    hand.answerFiles(QString::fromStdString(folder.file("")), QDialogButtonBox::Open);
    auto* browser = hand.dialog<ui::StudyBrowser>();
    ASSERT_TRUE(browser);
    ASSERT_TRUE(test::waitFor([&] { return !w.controller.isLoading(); }));
    ui::StudyList& list = browser->list();
    for (QTreeWidgetItemIterator at(&list, QTreeWidgetItemIterator::NoChildren); *at; ++at) {
        list.scrollToItem(*at);
        const QRect row = list.visualItemRect(*at);
        hand.click(list.viewport(), {row.left() + 10, row.center().y()});
    }
    hand.clickText(*browser, QStringLiteral("Open"));
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return !w.controller.isLoading() && w.current().vessels.tree; }, 4 * test::patienceMs));
    ASSERT_TRUE(w.current().shown().angiogram);
    hand.registerNow();

    EXPECT_LE(hand.clicks, 12);
    ASSERT_TRUE(w.current().shown().result);
    EXPECT_LT(offPx(*w.current().vessels.tree, truth, w.current().shown().cameraFromPatient), 6.0);
}

}   // namespace
}   // namespace angiopose::app
