// The states that commands and files lead to: modes with bars and captions, slices, message boxes.
#include "app/case_controller.h"
#include "app/document/edit_case.h"
#include "io/volume_file.h"
#include "tests/app/gallery/gallery.h"
#include "tests/app/wait_for.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/patience.h"
#include "ui/slices/slices_page.h"

#include <QAbstractButton>
#include <QAction>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <utility>

namespace angiopose::test {

void Gallery::showModes(ui::MainWindow& window)
{
    using enum ui::Command;
    const std::array modes{
        std::pair{Nudge, "nudging"},         std::pair{EditVessels, "editing"},   std::pair{MeasureLength, "length"},
        std::pair{MeasureAngle, "angle"},    std::pair{MeasureArea, "area"},      std::pair{Lasso, "lasso"},
        std::pair{Landmarks, "landmarking"}, std::pair{PickPivot, "pivot"},       std::pair{ShiftMask, "shifting"},
        std::pair{Swipe, "swipe"},           std::pair{MirrorView, "source"},     std::pair{Outline, "outline"},
        std::pair{ImageOnly, "image_only"},  std::pair{CornerOnly, "corner_only"}};
    for (const auto& [command, name] : modes) {
        QAction* action = window.actions()[command];
        if (!action->isEnabled()) {
            problems_ << QStringLiteral("%1 cannot be shown").arg(QLatin1String(name));
            continue;
        }
        action->trigger();
        showWindow(window, QString::fromLatin1(name));
        if (action->isChecked()) {
            action->trigger();
        }
        QTest::keyClick(&window, Qt::Key_Escape);
        QTest::qWait(50);
    }
}

void Gallery::showQuestions(ui::MainWindow& window, app::CaseController& controller)
{
    controller.open({QStringLiteral("/studies/2026-03/run-12.dcm")});
    if (!test::waitFor([&controller] { return !controller.isLoading(); })) {
        qFatal("The opening did not end.");
    }
    QTest::qWait(300);
    takeDialogs(window, QStringLiteral("not_found"));
    window.actions()[ui::Command::CloseCase]->trigger();
    QTest::qWait(300);
    takeDialogs(window, QStringLiteral("unsaved"));
    window.actions()[ui::Command::Messages]->trigger();
    QTest::qWait(300);
    takeDialogs(window, QStringLiteral("messages"));
}

void Gallery::runScan(const QString& path)
{
    ui::MainWindow window;
    app::CaseController controller(window);
    window.resize(1440, 900);
    window.show();
    openScan(controller, path);
    showWindow(window, QStringLiteral("scan"));
    showScanIn3d(window);
}

void Gallery::openScan(app::CaseController& controller, const QString& path)
{
    const auto isAtRest = [&controller] { return !controller.isLoading() && !controller.tracing().isRunning(); };
    controller.document().replace({}, {});
    controller.open({path});
    const auto isThere = [&] {
        const core::Vessels& vessels = controller.document().current().vessels;
        return isAtRest() && (vessels.scan || vessels.lumen);
    };
    if (!QTest::qWaitFor(isThere, 10 * patienceMs)) {
        qFatal("The scan did not open.");
    }
    QTest::qWait(500);
}

void Gallery::measureSlices(app::CaseController& controller, const ui::SliceModel& slices)
{
    using enum core::MeasurementKind;
    const Eigen::Vector3d at = slices.crosshair();
    const auto beside = [&at](double x, double y, double z) { return Eigen::Vector3d(at + Eigen::Vector3d(x, y, z)); };
    std::vector<core::SliceMeasurement> measured{
        {Length, core::BodyPlane::Axial, {beside(-6, -3, 0), beside(7, 4, 0)}, "neck"},
        {Angle, core::BodyPlane::Coronal, {beside(-8, 0, 10), beside(0, 0, 0), beside(9, 0, 12)}, ""},
        {Area,
         core::BodyPlane::Sagittal,
         {beside(0, -8, -8), beside(0, 7, -9), beside(0, 9, 8), beside(0, -6, 10)},
         ""}};
    controller.document().push(std::make_unique<app::ChangeMeasurements>(
        controller.document(),
        app::ChangeMeasurements::Values{std::vector<core::ImageMeasurement>{}, std::move(measured)},
        [] { return QStringLiteral("Measure"); }));
}

/// Shows a scan during tracing, with the slices first in the middle, then in the corner.
void Gallery::showScan(ui::MainWindow& window, app::CaseController& controller)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("scan.nrrd"));
    if (!io::writeVolume(forkScan(), path.toStdString())) {
        qFatal("The scan was not written.");
    }
    openScan(controller, path);
    showWindow(window, QStringLiteral("scan"));
    showScanIn3d(window);
    window.actions()[ui::Command::SlicesLarge]->setChecked(true);
    QTest::qWait(500);
    showWindow(window, QStringLiteral("slices"));
    measureSlices(controller, window.slices());
    showWindow(window, QStringLiteral("slices_measured"));
    window.actions()[ui::Command::PaintMask]->setChecked(true);
    if (!test::waitFor([&] { return !controller.mask().isPreparing(); })) {
        qFatal("The mask was not copied.");
    }
    ui::SliceView& axial = window.slicesPage().view(core::BodyPlane::Axial);
    QTest::mouseMove(&axial, axial.rect().center() + QPoint(40, 20));
    QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center() + QPoint(40, 20));
    showWindow(window, QStringLiteral("mask_brush"));
    window.actions()[ui::Command::PaintMask]->setChecked(false);
    window.resize(1024, 720);
    showWindow(window, QStringLiteral("slices_small"));
    window.resize(1440, 900);
}

/// Shows the scan behind its vessels, first in the layout of the tracing step, then alone.
void Gallery::showScanIn3d(ui::MainWindow& window)
{
    using enum ui::Command;
    window.actions()[ScanIn3d]->setChecked(true);
    goToStep(window, ui::Step::Vessels);
    QTest::qWait(2500);   // workers prepare, render and refine it
    showWindow(window, QStringLiteral("step_tracing"));
    window.actions()[NextScanRendering]->trigger();
    window.actions()[CornerOnly]->setChecked(true);
    QTest::qWait(2500);
    showWindow(window, QStringLiteral("scan_in_3d"));
    window.actions()[CornerOnly]->setChecked(false);
    window.actions()[NextScanRendering]->trigger();
    window.actions()[ScanIn3d]->setChecked(false);
    goToStep(window, ui::Step::Register);
}

void Gallery::goToStep(ui::MainWindow& window, ui::Step step)
{
    QTest::mouseClick(window.steps().findChildren<QAbstractButton*>().at(static_cast<int>(step)), Qt::LeftButton);
    QTest::qWait(100);
}

void Gallery::showSteps(ui::MainWindow& window)
{
    goToStep(window, ui::Step::Review);
    showWindow(window, QStringLiteral("step_review"));
    window.actions()[ui::Command::FoldRight]->setChecked(true);
    showWindow(window, QStringLiteral("folded"));
    window.actions()[ui::Command::FoldRight]->setChecked(false);
    goToStep(window, ui::Step::Register);
}

}   // namespace angiopose::test
