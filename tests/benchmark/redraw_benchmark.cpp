// How long a pose edit takes until both views show it. Run it on a screen or under xvfb-run.
#include "core/simulation/simulated_case.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QTest>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace {

constexpr int editCount = 100;
constexpr double sourceToDetectorMm = 1000.0;

/// The two views as the main window places them.
struct Window {
    QWidget widget;
    ui::TreeView* tree = new ui::TreeView;
    ui::AngiogramView* angiogram = new ui::AngiogramView;

    Window()
    {
        auto* layout = new QHBoxLayout(&widget);
        auto* column = new QVBoxLayout;
        column->addStretch(1);
        column->addWidget(tree);
        tree->setFixedSize(330, 330);
        layout->addLayout(column);
        layout->addWidget(angiogram, 1);
        widget.resize(1400, 900);
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

void editAndWait(Window& window, const core::RigidTransform& pose)
{
    const int before = window.angiogram->renderCount();
    const int beforeTree = window.tree->renderCount();
    bool isShown = false;
    const auto swapped =
        QObject::connect(window.angiogram, &QOpenGLWidget::frameSwapped, [&isShown] { isShown = true; });
    window.angiogram->setPose(pose);
    window.tree->scene().setPose(pose);
    window.tree->update();
    while (!isShown || window.angiogram->renderCount() == before || window.tree->renderCount() == beforeTree) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    QObject::disconnect(swapped);
}

}   // namespace

int main(int argc, char** argv)
{
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    const core::SimulatedCase simulated = core::simulateCase(1, {.pointSpacingMm = 0.5});
    Window window;
    show(window, simulated);
    if (!QTest::qWaitForWindowExposed(&window.widget)) {
        std::fputs("The window did not appear.\n", stderr);
        return 1;
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
    std::printf("pose edit, both views, 1400x900, %zu points: median %.1f ms, p95 %.1f ms, processor %.1f ms\n",
                simulated.tree.pointCount(), wallMs[editCount / 2], wallMs[editCount * 95 / 100], processorMs);
    return 0;
}
