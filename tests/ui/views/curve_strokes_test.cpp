#include "ui/views/tools/curve_strokes.h"

#include "ui/scenes/fill_strokes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace angiopose;

namespace {

constexpr int sidePx = 120;

ui::CurveCanvas square()
{
    ui::CurveCanvas canvas;
    canvas.widthPx = canvas.heightPx = sidePx;
    return canvas;
}

core::Centerline2d wave(double fromPx, double toPx)
{
    core::Curve2d curve;
    for (double x = fromPx; x <= toPx; x += 0.5) {
        curve.pointsPx.emplace_back(x, 60.0 + 20.0 * std::sin(0.05 * x));
    }
    return {{curve}};
}

std::vector<std::uint32_t> picture(const ui::StrokeMesh& mesh)
{
    std::vector<std::uint32_t> pixels(sidePx * sidePx, 0xFF000000U);
    ui::fillStrokes(mesh, sidePx, {pixels.data(), sidePx, sidePx});
    return pixels;
}

/// The same curves drawn completely: the canvas is so large that no part is skipped as outside.
ui::StrokeMesh drawnWhole(const core::Centerline2d& curves, const ui::CurveStyle& look)
{
    ui::CurveCanvas endless = square();
    endless.widthPx = endless.heightPx = 1e5;
    ui::StrokeMesh mesh;
    addCurves(mesh, endless, curves, look);
    return mesh;
}

TEST(CurveStrokes, LeaveOutWhatDoesNotShowAndNothingElse)
{
    const core::Centerline2d curves = wave(0.0, 5000.0);
    for (const bool isFaint : {false, true}) {
        const ui::CurveStyle look{.isFaint = isFaint};
        ui::StrokeMesh mesh;
        addCurves(mesh, square(), curves, look);
        const ui::StrokeMesh whole = drawnWhole(curves, look);
        EXPECT_LT(mesh.vertexCount(), whole.vertexCount() / 10);
        EXPECT_EQ(picture(mesh), picture(whole));
    }
}

TEST(CurveStrokes, AreNothingForCurvesBesideThePicture)
{
    ui::StrokeMesh mesh;
    addCurves(mesh, square(), wave(400.0, 900.0), {.suspectIds = {0}});
    EXPECT_EQ(mesh.vertexCount(), 0U);
}

TEST(CurveStrokes, AreDrawnAnewForOtherCurvesOrAnotherPicture)
{
    ui::CurveStrokeCache kept;
    const std::vector<float> first = kept.of(1, square(), wave(0.0, 100.0), {}).points;
    EXPECT_EQ(kept.of(1, square(), wave(0.0, 100.0), {}).points, first);
    EXPECT_NE(kept.of(2, square(), wave(0.0, 50.0), {}).points, first);
    const std::vector<float> second = kept.of(2, square(), wave(0.0, 50.0), {}).points;
    ui::CurveCanvas moved = square();
    moved.canvasFromImage.translation().x() = 3.0;
    EXPECT_NE(kept.of(2, moved, wave(0.0, 50.0), {}).points, second);
}

}   // namespace
