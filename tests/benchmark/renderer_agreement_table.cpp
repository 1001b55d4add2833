// Measures the difference between the overlay images of the painter and of VTK, and the amount of data that VTK passes
// to OpenGL. Run it on a screen or under xvfb-run -a.
#include "tests/ui/renderer_agreement.h"

#include "ui/views/gl_driver.h"

#include <QGuiApplication>
#include <QImage>

#include <algorithm>
#include <cstdio>

using namespace angiopose;

namespace {

struct Worst {
    double shiftPx = 0.0;
    int gray = 0;
};

Worst printCase(std::uint64_t seed, ui::GlOverlay& gl)
{
    Worst worst;
    for (const test::OverlayState& state : test::overlayStates(seed)) {
        for (const int percent : {100, 200}) {
            const test::Agreement agreement = test::agreementOf(state, gl, 512 * percent / 100, percent / 100.0);
            std::printf(
                "%4d  %-26s %4d %%  %6.3f px at (%6.1f, %6.1f) of %5zu  %4d grey at (%4d, %4d)  %5.1f %% edges\n",
                static_cast<int>(seed), state.name.c_str(), percent, agreement.lineShiftPx, agreement.worstLineAt.x(),
                agreement.worstLineAt.y(), agreement.lineSamples, agreement.grayDifference, agreement.worstGrayAt.x(),
                agreement.worstGrayAt.y(), 100.0 * agreement.edgeShare);
            worst.shiftPx = std::max(worst.shiftPx, agreement.lineShiftPx);
            worst.gray = std::max(worst.gray, agreement.grayDifference);
        }
    }
    return worst;
}

/// OpenGL work of one image of a state.
ui::VtkOverlay::RenderStats makeRetrieval(const test::OverlayState& state, ui::GlOverlay& gl, int width, int height)
{
    ui::OverlayScene scene;
    state.apply(scene);
    scene.setLineWidthPx(2.4);
    QImage picture(width, height, QImage::Format_RGB32);
    gl.draw(scene, false, {}, {reinterpret_cast<std::uint32_t*>(picture.bits()), width, height});
    return gl.renderStats();
}

void printWork(ui::GlOverlay& gl)
{
    std::puts("\nhanded to OpenGL for one picture: vertices, draw calls");
    for (const test::OverlayState& state : test::overlayStates(1)) {
        const ui::VtkOverlay::RenderStats small = makeRetrieval(state, gl, 1920, 1080);
        const ui::VtkOverlay::RenderStats large = makeRetrieval(state, gl, 3840, 2160);
        std::printf("  %-26s 1920x1080: %6zu, %zu   3840x2160: %6zu, %zu   ratio %.2f\n", state.name.c_str(),
                    small.vertices, small.drawCalls, large.vertices, large.drawCalls,
                    static_cast<double>(large.vertices) / static_cast<double>(small.vertices));
    }
}

}   // namespace

int main(int argc, char** argv)
{
    const QGuiApplication application(argc, argv);
    const ui::GlDriver& driver = ui::glDriver();
    std::printf("OpenGL: %s, %s\n", qPrintable(driver.vendor), qPrintable(driver.renderer));
    ui::GlOverlay gl;
    if (!gl.isReady()) {
        std::fputs("No OpenGL 3.2 here.\n", stderr);
        return 1;
    }
    Worst worst;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Worst here = printCase(seed, gl);
        worst = {std::max(worst.shiftPx, here.shiftPx), std::max(worst.gray, here.gray)};
    }
    std::printf("worst: lines %.3f px, colours outside of edges %d grey values\n", worst.shiftPx, worst.gray);
    printWork(gl);
    return 0;
}
