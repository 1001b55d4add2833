// Processor time of the events that go through the slices of a large scan, each with all the painting it causes: of the
// window's thread, which must stay below 16 ms, and of all threads together, which share the cutting and painting. Run
// it on a screen or under xvfb-run -a -s "-screen 0 1920x1200x24".
//   slice_benchmark [columns=512] [slices=300]
#include "core/simulation/simulate_cta.h"
#include "ui/slices/slices_page.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace angiopose;

namespace {

constexpr int eventCount = 60;

double processorMs(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Prints the median and worst time of an action, painting included.
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
    page.resize(1400, 940);   // beside the columns of a window of 1920 × 1080
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
    return 0;
}
