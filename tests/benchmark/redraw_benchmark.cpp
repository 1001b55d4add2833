// Measures redraw times:
// - a pose edit, until both views show it;
// - a drag in nudge mode, until the whole window shows it, with one view and with two side by side;
// - the tree's lines alone, by our rasterizer and by QPainter;
// - a rotation of the 3-D view with a scan behind the vessels.
// With --scan only the last, with --drag only drags. Run it on a screen or under
// xvfb-run -a -s "-screen 0 1920x1200x24".
#include "app/case_controller.h"
#include "core/geometry/pose_offset.h"
#include "core/simulation/simulate_cta.h"
#include "core/simulation/simulated_case.h"
#include "tests/benchmark/timed_application.h"
#include "tests/support/simulated_views.h"
#include "ui/main_window.h"
#include "ui/places/side_by_side.h"
#include "ui/scenes/fill_strokes.h"
#include "ui/scenes/overlay_pens.h"
#include "ui/scenes/overlay_strokes.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QPainter>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace angiopose;

namespace {

constexpr int editCount = 100;
constexpr double sourceToDetectorMm = 1000.0;

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

/// Edits the pose and waits until both views have drawn it and the display server has received the pixels.
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
    QApplication::processEvents();   // shows the rendered 3-D image in the window
    window.widget.screen()->grabWindow(window.widget.winId(), 0, 0, 1, 1);
}

/// Prints the time of pose edits in a window of this size; returns false if the window did not appear.
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

/// Two views of one tree of 3000 points, with frames of 1024 × 1024 as from C-arms.
core::Case twoLargeViews()
{
    core::DsaOptions dsa;
    dsa.width = dsa.height = 1024;
    dsa.frameCount = 3;
    core::Case values;
    values.views.clear();
    for (const std::uint64_t seed : {1U, 4U}) {
        const core::SimulatedCase simulated = core::simulateView(1, seed, {.pointSpacingMm = 0.5}, dsa);
        values.vessels.tree = std::make_shared<const core::VesselTree>(simulated.tree);
        values.views.push_back(test::viewOf(simulated));
        values.views.back().cameraFromPatient = simulated.trueCameraFromPatient;
    }
    return values;
}

/// Waits until everything that shows a pose has been redrawn.
class AllRedrawn {
public:
    AllRedrawn(ui::MainWindow& window) : window_(window), images_(window.sideBySide().images()), before_(counts()) {}
    void wait() const
    {
        const auto isStale = [this] {
            const std::vector<int> now = counts();
            return !std::ranges::equal(before_, now, std::ranges::less());
        };
        while (isStale()) {
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        QApplication::processEvents();
        window_.screen()->grabWindow(window_.winId(), 0, 0, 1, 1);
    }

private:
    std::vector<int> counts() const
    {
        std::vector<int> counts{window_.treeView().renderCount()};
        std::ranges::transform(images_, std::back_inserter(counts), &ui::AngiogramView::renderCount);
        return counts;
    }

    ui::MainWindow& window_;
    std::vector<ui::AngiogramView*> images_;
    std::vector<int> before_;
};

/// Prints the time of the steps of a drag in the whole window, including the assessment, as in nudge mode.
bool measureDrag(std::size_t viewCount)
{
    ui::MainWindow window;
    app::CaseController controller(window);
    window.resize(1920, 1080);
    window.show();
    core::Case views = twoLargeViews();
    views.views.resize(viewCount);
    controller.document().replace(std::move(views), {});
    window.actions()[ui::Command::SideBySide]->setChecked(true);
    if (!QTest::qWaitForWindowExposed(&window) ||
        !QTest::qWaitFor([&controller] { return controller.evaluation() != nullptr; }, 60000)) {
        std::fputs("The window did not appear.\n", stderr);
        return false;
    }
    QTest::qWait(3000);   // thumbnails of the views are created
    window.actions()[ui::Command::Nudge]->setChecked(true);
    ui::AngiogramView& image = window.angiogramView();
    const QPoint from = image.rect().center() + QPoint(5, 7);
    QTest::mousePress(&image, Qt::LeftButton, {}, from);
    std::vector<double> wallMs;
    for (int i = 0; i < editCount; ++i) {
        QElapsedTimer timer;
        timer.start();
        const AllRedrawn all(window);
        QTest::mouseMove(&image, from + QPoint(10 + i % 50, 10 + i % 31));
        all.wait();
        wallMs.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    QTest::mouseRelease(&image, Qt::LeftButton, {}, from);
    std::ranges::sort(wallMs);
    const double medianMs = wallMs[editCount / 2];
    std::printf("drag in nudge mode, whole window, %dx%d, %zu view(s): median %.1f ms (%.0f frames/s), p95 %.1f ms\n",
                window.width(), window.height(), viewCount, medianMs, 1e3 / medianMs, wallMs[editCount * 95 / 100]);
    return true;
}

/// Times of mouse rotations of the 3-D view until it has been redrawn, ms.
std::vector<double> turnMs(ui::TreeView& tree)
{
    const QPoint from = tree.rect().center();
    QTest::mousePress(&tree, Qt::LeftButton, {}, from);
    std::vector<double> wallMs;
    for (int i = 0; i < editCount; ++i) {
        QElapsedTimer timer;
        timer.start();
        const int before = tree.renderCount();
        QTest::mouseMove(&tree, from + QPoint(10 + i % 60, 10 + i % 31));
        while (tree.renderCount() == before) {
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        wallMs.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    QTest::mouseRelease(&tree, Qt::LeftButton, {}, from);
    std::ranges::sort(wallMs);
    return wallMs;
}

/// Prints the cost of a scan behind the vessels: the time until it is shown, and the time of each rotation.
bool measureScan(benchmarks::TimedApplication& application, const core::SimulatedCta& cta)
{
    ui::MainWindow window;
    app::CaseController controller(window);
    window.resize(1920, 1080);
    window.show();
    core::Case scan;
    scan.vessels.tree = std::make_shared<const core::VesselTree>(cta.tree);
    scan.vessels.scan = std::make_shared<const core::Volume>(cta.volume);
    controller.document().replace(std::move(scan), {});
    window.actions()[ui::Command::CornerOnly]->setChecked(true);
    if (!QTest::qWaitForWindowExposed(&window)) {
        return false;
    }
    QTest::qWait(2000);
    ui::TreeView& tree = window.treeView();
    for (const bool isShown : {false, true}) {
        application.isWatching = isShown;
        window.actions()[ui::Command::ScanIn3d]->setChecked(isShown);
        QElapsedTimer timer;
        timer.start();
        if (isShown && !QTest::qWaitFor([&] { return controller.scan().isShown(); }, 60000)) {
            return false;
        }
        const double readyMs = 1e-6 * static_cast<double>(timer.nsecsElapsed());
        QTest::qWait(3000);
        const std::vector<double> wallMs = turnMs(tree);
        std::printf("turn of the 3-D view, %dx%d, %s: median %.1f ms, p95 %.1f ms\n", tree.width(), tree.height(),
                    isShown ? "scan behind the vessels" : "vessels alone", wallMs[editCount / 2],
                    wallMs[editCount * 95 / 100]);
        if (isShown) {
            std::printf("scan of %d x %d x %d: first picture after %.0f ms\n", cta.volume.geometry.size.x(),
                        cta.volume.geometry.size.y(), cta.volume.geometry.size.z(), readyMs);
        }
        QTest::qWait(3000);
    }
    application.isWatching = false;
    application.printSlow();
    return true;
}

/// Median time of one call over many, ms.
template <class Draw>
double medianMsOf(const Draw& draw)
{
    std::vector<double> wallMs;
    for (int i = 0; i < 21; ++i) {
        QElapsedTimer timer;
        timer.start();
        draw();
        wallMs.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    std::ranges::nth_element(wallMs, wallMs.begin() + 10);
    return wallMs[10];
}

/// Draws the tree's centerlines or edges with their borders by means of QPainter, for comparison.
void drawByQt(const ui::OverlayContent& content, const ui::DeviceFromImage& device, QImage& picture)
{
    const bool isTube = content.mode == ui::OverlayMode::Tube;
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto lineOf = [&](const std::vector<ui::ProjectedPoint>& run, double side) {
        QPolygonF line;
        for (const ui::ProjectedPoint& point : run) {
            const Eigen::Vector2d at = device * point.edgePx(side);
            line << QPointF(at.x(), device.height - at.y());
        }
        return line;
    };
    const auto forEachLine = [&](const auto& draw) {
        for (const ui::ProjectedBranch& branch : content.projected) {
            for (const auto& run : branch.runs) {
                for (const double side : isTube ? std::vector<double>{1.0, -1.0} : std::vector<double>{0.0}) {
                    draw(lineOf(run, side));
                }
            }
        }
    };
    const double width = (isTube ? ui::edgeWidth : 1.0) * content.lineWidthPx;
    const QColor tone = toQColor(ui::branchColors(ui::palette(ui::ThemeMode::Dark)).plain);
    const QColor shade = toQColor(ui::palette(ui::ThemeMode::Dark).canvas, ui::haloOpacity);
    for (const auto& [color, widthPx] :
         {std::pair(shade, width + ui::haloWidth * content.lineWidthPx), {tone, width}}) {
        painter.setPen(QPen(color, widthPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        forEachLine([&painter](const QPolygonF& line) { painter.drawPolyline(line); });
    }
}

/// Prints the time of drawing the tree's lines alone, without the frame, on one thread.
void measureLines(const core::SimulatedCase& simulated, const QSize& size, ui::OverlayMode mode)
{
    ui::OverlayScene scene;
    scene.setTree(simulated.tree);
    scene.setCamera(simulated.camera);
    scene.setPose(simulated.initialCameraFromPatient);
    scene.setMode(mode);
    scene.setLineWidthPx(2.4);
    const double wide = 512.0 * size.width() / size.height();
    scene.setViewRect({256.0 - 0.5 * wide, 256.0 + 0.5 * wide, -0.5, 511.5});
    const ui::OverlayContent& content = scene.content();
    const ui::DeviceFromImage device{content.viewRect, size.width(), size.height()};
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(Qt::black);
    const double ownMs = medianMsOf([&] {
        ui::fillStrokes(ui::overlayStrokes(content, device), size.height(),
                        {reinterpret_cast<std::uint32_t*>(picture.bits()), size.width(), size.height()});
    });
    const double qtMs = medianMsOf([&] { drawByQt(content, device, picture); });
    std::printf("lines alone, %dx%d, %s: ours %.1f ms, QPainter %.1f ms\n", size.width(), size.height(),
                mode == ui::OverlayMode::Tube ? "tubes" : "centrelines", ownMs, qtMs);
}

}   // namespace

int main(int argc, char** argv)
{
    const QTemporaryDir home;   // neither reads nor changes the user's settings
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
    benchmarks::TimedApplication application(argc, argv);
    ui::applyTheme(application, ui::ThemeMode::Dark);
    QApplication::setQuitOnLastWindowClosed(false);
    if (QApplication::arguments().contains(QStringLiteral("--drag"))) {
        return measureDrag(1) && measureDrag(2) ? 0 : 1;
    }
    const core::SimulatedCase simulated = core::simulateCase(1, {.pointSpacingMm = 0.5});
    bool isMeasured = measureScan(application, core::simulateCta(1, {}, {.size = {320, 320, 280}}));
    if (QApplication::arguments().contains(QStringLiteral("--scan"))) {
        return isMeasured ? 0 : 1;
    }
    for (const QSize& size : {QSize(1400, 900), QSize(1920, 1080)}) {
        for (const ui::OverlayMode mode : {ui::OverlayMode::Centerline, ui::OverlayMode::Tube}) {
            isMeasured = isMeasured && measure(simulated, size, mode);
        }
    }
    for (const std::size_t viewCount : {1U, 2U}) {
        isMeasured = isMeasured && measureDrag(viewCount);
    }
    for (const ui::OverlayMode mode : {ui::OverlayMode::Centerline, ui::OverlayMode::Tube}) {
        measureLines(simulated, QSize(1920, 1080), mode);
    }
    return isMeasured ? 0 : 1;
}
