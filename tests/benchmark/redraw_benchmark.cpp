// How long a pose edit takes until both views show it. Run it on a screen or under
// xvfb-run -a -s "-screen 0 1920x1200x24".
#include "core/geometry/pose_offset.h"
#include "core/simulation/simulated_case.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QScreen>
#include <QTest>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace angiopose;

namespace {

constexpr int editCount = 100;
constexpr double sourceToDetectorMm = 1000.0;

/// The two views as the main window places them.
struct Window {
    QWidget widget;
    ui::TreeView* tree = new ui::TreeView;
    ui::AngiogramView* angiogram = new ui::AngiogramView;

    explicit Window(const QSize& size)
    {
        auto* layout = new QHBoxLayout(&widget);
        auto* column = new QVBoxLayout;
        column->addStretch(1);
        column->addWidget(tree);
        tree->setFixedSize(330, 330);
        layout->addLayout(column);
        layout->addWidget(angiogram, 1);
        widget.resize(size);
    }
};

void show(Window& window, const core::SimulatedCase& simulated)
{
    const core::ImageF& frame = simulated.angiogram.frames[simulated.angiogram.frames.size() / 2];
    window.angiogram->scene().setTree(simulated.tree);
    window.angiogram->setCamera(simulated.camera);
    window.angiogram->setPivot(core::centroidInPatient(simulated.tree));
    window.angiogram->setPose(simulated.initialCameraFromPatient);
    window.angiogram->setFrame(frame);
    window.tree->scene().setTree(simulated.tree);
    window.tree->scene().setCamera(simulated.camera, sourceToDetectorMm);
    window.tree->scene().setPose(simulated.initialCameraFromPatient);
    window.tree->scene().setFrame(frame);
    window.widget.show();
}

/// Makes an edit and waits until both views have drawn it and the display server has taken the pixels.
void editAndWait(Window& window, const core::RigidTransform& pose)
{
    const int before = window.angiogram->renderCount();
    const int beforeTree = window.tree->renderCount();
    window.angiogram->setPose(pose);
    window.tree->scene().setPose(pose);
    window.tree->requestRender();
    while (window.angiogram->renderCount() == before || window.tree->renderCount() == beforeTree) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    QApplication::processEvents();   // the 3-D view's picture goes to the window
    window.widget.screen()->grabWindow(window.widget.winId(), 0, 0, 1, 1);
}

/// Prints the time of pose edits in a window of this size; false when it did not appear.
bool measure(const core::SimulatedCase& simulated, const QSize& size, ui::OverlayMode mode)
{
    Window window(size);
    show(window, simulated);
    window.angiogram->scene().setMode(mode);
    if (!QTest::qWaitForWindowExposed(&window.widget)) {
        std::fputs("The window did not appear.\n", stderr);
        return false;
    }
    QTest::qWait(500);

    std::vector<double> wallMs;
    const Eigen::Vector3d pivot = core::centroidInPatient(simulated.tree);
    const std::clock_t processorBefore = std::clock();
    for (int i = 0; i < editCount; ++i) {
        const core::PoseOffset offset{.rightMm = 0.2 * i, .rollDeg = 0.1 * i};
        QElapsedTimer timer;
        timer.start();
        editAndWait(window, core::applyOffset(simulated.initialCameraFromPatient, offset, pivot, simulated.camera));
        wallMs.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    const double processorMs = 1e3 * static_cast<double>(std::clock() - processorBefore) / CLOCKS_PER_SEC / editCount;
    std::sort(wallMs.begin(), wallMs.end());
    const double medianMs = wallMs[editCount / 2];
    std::printf(
        "pose edit, both views, %dx%d, %zu points, %s: median %.1f ms (%.0f frames/s), p95 %.1f ms, "
        "processor %.1f ms\n",
        window.widget.width(), window.widget.height(), simulated.tree.pointCount(),
        mode == ui::OverlayMode::Tube ? "tubes" : "centrelines", medianMs, 1e3 / medianMs, wallMs[editCount * 95 / 100],
        processorMs);
    return true;
}

}   // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    const core::SimulatedCase simulated = core::simulateCase(1, {.pointSpacingMm = 0.5});
    bool isMeasured = true;
    for (const QSize& size : {QSize(1400, 900), QSize(1920, 1080)}) {
        for (const ui::OverlayMode mode : {ui::OverlayMode::Centerline, ui::OverlayMode::Tube}) {
            isMeasured = isMeasured && measure(simulated, size, mode);
        }
    }
    return isMeasured ? 0 : 1;
}
