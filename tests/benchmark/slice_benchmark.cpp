// Processor time of the events that go through the slices of a large scan, each with all the painting it causes: of the
// window's thread, which must stay below 16 ms, and of all threads together, which share the reslicing and painting.
// Run it on a screen or under xvfb-run -a -s "-screen 0 1920x1200x24". slice_benchmark [columns=512] [slices=300]
#include "core/imaging/mask_brush.h"
#include "core/imaging/mask_cut.h"
#include "core/simulation/simulate_cta.h"
#include "ui/slices/slices_page.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>

using namespace angiopose;

namespace {

constexpr int eventCount = 60;

double processorMs(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Prints the median and worst time of an action, including painting.
template <class Action>
void measure(const char* what, const Action& act)
{
    std::vector<double> windowMs, allMs;
    for (int i = 0; i < eventCount; ++i) {
        const double before = processorMs(CLOCK_THREAD_CPUTIME_ID);
        const double allBefore = processorMs(CLOCK_PROCESS_CPUTIME_ID);
        act(i);
        QApplication::processEvents();
        windowMs.push_back(processorMs(CLOCK_THREAD_CPUTIME_ID) - before);
        allMs.push_back(processorMs(CLOCK_PROCESS_CPUTIME_ID) - allBefore);
    }
    std::sort(windowMs.begin(), windowMs.end());
    std::sort(allMs.begin(), allMs.end());
    std::printf("%-44s median %5.1f ms, worst %5.1f ms; all threads median %5.1f ms, worst %5.1f ms\n", what,
                windowMs[windowMs.size() / 2], windowMs.back(), allMs[allMs.size() / 2], allMs.back());
}

void wheel(ui::SliceView& view, int step)
{
    const QPointF at = view.rect().center();
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * step}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&view, &event);
}

void measureAll(ui::SliceModel& model, ui::SlicesPage& page)
{
    ui::SliceView& axial = page.view(core::BodyPlane::Axial);
    for (const core::BodyPlane plane : core::bodyPlanes) {
        ui::SliceView& view = page.view(plane);
        const QByteArray name = QStringLiteral("wheel, %1").arg(ui::nameOf(plane)).toUtf8();
        measure(name.constData(), [&](int i) { wheel(view, i < eventCount / 2 ? 1 : -1); });
    }
    QTest::mousePress(&axial, Qt::LeftButton, {}, axial.rect().center());
    measure("drag of the cross-hair: all three planes",
            [&](int i) { QTest::mouseMove(&axial, axial.rect().center() + QPoint(2 * i + 10, i)); });
    QTest::mouseRelease(&axial, Qt::LeftButton, {}, axial.rect().center());
    measure("window and level, all three planes", [&](int i) { model.setWindow({600.0 + i, 200.0}); });
    measure("threshold preview, all three planes", [&](int i) { model.setPreviewFrom(150.0 + i); });
    measure("pointer moves over a slice",
            [&](int i) { QTest::mouseMove(&axial, axial.rect().center() + QPoint(i, -i)); });
}

enum class BrushShape { Disc, Ball };

/// Measures the work of a brush move in the window's thread, alternately erasing and painting.
void measureBrush(const char* what, ui::SliceModel& model, ui::SliceView& view, core::VoxelMask& draft,
                  BrushShape shape, double radiusMm)
{
    measure(what, [&](int i) {
        const QPointF from = view.rect().center() + QPoint(2 * i, i);
        const core::BrushStep step{view.patientFromWidget(from), view.patientFromWidget(from + QPointF(2, 1))};
        const core::MaskBrush brush{i % 2 == 0 ? core::BrushMode::Paint : core::BrushMode::Erase, radiusMm};
        const core::MaskChange change =
            core::makeMaskChange(shape == BrushShape::Ball ? core::brushVolume(draft, brush, step)
                                                           : core::brushSlice(draft, view.grid(), brush, step));
        if (!change.runs.empty()) {
            core::flip(draft, change);
            model.notifyDraftChanged(core::boxOf(draft.geometry, change));
        }
    });
}

void measureMask(ui::SliceModel& model, ui::SlicesPage& page)
{
    const auto draft = std::make_shared<core::VoxelMask>(*model.lumen());
    model.setDraft(draft);
    QApplication::processEvents();
    ui::SliceView& axial = page.view(core::BodyPlane::Axial);
    measureBrush("brush, disc of 5 mm in the axial slice", model, axial, *draft, BrushShape::Disc, 5.0);
    measureBrush("brush, disc of 5 mm in the sagittal slice", model, page.view(core::BodyPlane::Sagittal), *draft,
                 BrushShape::Disc, 5.0);
    measureBrush("brush, ball of 5 mm", model, axial, *draft, BrushShape::Ball, 5.0);
    measureBrush("brush, ball of 25 mm", model, axial, *draft, BrushShape::Ball, 25.0);
    core::MaskCut cut;
    cut.slice = axial.grid();
    cut.outline = {{100, 100}, {400, 100}, {400, 400}, {100, 400}};
    cut.halfDepthMm = std::numeric_limits<double>::infinity();
    core::MaskChange change;
    measure("worker: scissors through the whole depth",
            [&](int) { change = core::makeMaskChange(core::cutVoxels(*draft, cut)); });
    measure("taking that cut, and undoing it", [&](int) {
        core::flip(*draft, change);
        model.notifyDraftChanged(core::boxOf(draft->geometry, change));
    });
    measure("opacity of the mask, all three planes", [&](int i) { model.setMaskOpacity(0.2 + 0.01 * i); });
}

}   // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    const int columns = argc > 1 ? std::atoi(argv[1]) : 512;
    const int slices = argc > 2 ? std::atoi(argv[2]) : 300;
    core::SimulatedCta cta = core::simulateCta(1, {}, {.size = {columns, columns, slices}});
    core::VoxelMask lumen(cta.volume.geometry);
    for (std::size_t i = 0; i < lumen.voxels.size(); ++i) {
        lumen.voxels[i] = cta.volume.value(i) > 250.0 ? 1 : 0;
    }
    ui::SliceModel model;
    ui::SlicesPage page(model);
    page.resize(1400, 940);   // the space beside the columns of a 1920 × 1080 window
    model.setScan(std::make_shared<const core::Volume>(std::move(cta.volume)),
                  std::make_shared<const core::VoxelMask>(std::move(lumen)));
    model.setTree(std::make_shared<const core::VesselTree>(std::move(cta.tree)));
    page.show();
    if (!QTest::qWaitForWindowExposed(&page)) {
        std::fputs("The window did not appear.\n", stderr);
        return 1;
    }
    std::printf("%d x %d x %d voxels, page of %d x %d\n", columns, columns, slices, page.width(), page.height());
    measureAll(model, page);
    measureMask(model, page);
    return 0;
}
