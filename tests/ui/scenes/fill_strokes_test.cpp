#include "ui/scenes/fill_strokes.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

using namespace angiopose;

namespace {

constexpr std::uint32_t black = 0xFF000000U;

struct Sheet {
    explicit Sheet(int columns, int rows)
        : width(columns), height(rows), pixels(static_cast<std::size_t>(columns * rows), black)
    {
    }
    ui::Canvas canvas() { return {pixels.data(), width, height}; }
    int redAt(int x, int y) const
    {
        return static_cast<int>(pixels[static_cast<std::size_t>(y * width + x)] >> 16U & 0xFFU);
    }

    int width;
    int height;
    std::vector<std::uint32_t> pixels;
};

std::int32_t addVertex(ui::StrokeMesh& mesh, float x, float y, std::uint8_t red, std::uint8_t alpha)
{
    mesh.points.insert(mesh.points.end(), {x, y, 0.0F});
    mesh.colors.insert(mesh.colors.end(), {red, 0, 0, alpha});
    return static_cast<std::int32_t>(mesh.vertexCount()) - 1;
}

TEST(FillStrokes, CoversAFanOfTrianglesOnceAndWithoutGaps)
{
    // Half opaque, so that a pixel drawn twice would be brighter and a missing one black.
    ui::StrokeMesh mesh;
    addVertex(mesh, 31.3F, 29.7F, 255, 128);
    for (int k = 0; k < 17; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 17.0;
        addVertex(mesh, static_cast<float>(31.3 + 80.0 * std::cos(angle)),
                  static_cast<float>(29.7 + 80.0 * std::sin(angle)), 255, 128);
    }
    for (int k = 0; k < 17; ++k) {
        mesh.triangles.insert(mesh.triangles.end(), {0, 1 + k, 1 + (k + 1) % 17});
    }
    Sheet sheet(64, 64);
    ui::fillStrokes(mesh, 64.0, sheet.canvas());
    test::forEachPixel(64, 64, [&](int x, int y) { EXPECT_NEAR(sheet.redAt(x, y), 128, 1) << x << ' ' << y; });
}

TEST(FillStrokes, PaintsExactlyThePixelsWhoseCentersAreInside)
{
    ui::StrokeMesh mesh;   // a square from (2, 1) to (5, 4), y up
    addVertex(mesh, 2.0F, 1.0F, 255, 255);
    addVertex(mesh, 5.0F, 1.0F, 255, 255);
    addVertex(mesh, 5.0F, 4.0F, 255, 255);
    addVertex(mesh, 2.0F, 4.0F, 255, 255);
    mesh.triangles = {0, 1, 2, 0, 2, 3};
    Sheet sheet(8, 6);
    ui::fillStrokes(mesh, 6.0, sheet.canvas());
    test::forEachPixel(8, 6, [&](int x, int y) {
        const bool isInside = x >= 2 && x < 5 && y >= 2 && y < 5;
        EXPECT_EQ(sheet.redAt(x, y), isInside ? 255 : 0) << x << ' ' << y;
    });
}

TEST(FillStrokes, ShadesLinearlyBetweenTheCorners)
{
    ui::StrokeMesh mesh;
    addVertex(mesh, 0.0F, 0.0F, 0, 255);
    addVertex(mesh, 100.0F, 0.0F, 200, 255);
    addVertex(mesh, 100.0F, 4.0F, 200, 255);
    addVertex(mesh, 0.0F, 4.0F, 0, 255);
    mesh.triangles = {0, 1, 2, 2, 3, 0};   // either winding order
    Sheet sheet(100, 4);
    ui::fillStrokes(mesh, 4.0, sheet.canvas());
    for (int x = 0; x < 100; ++x) {
        EXPECT_NEAR(sheet.redAt(x, 2), 2.0 * (x + 0.5), 1.0) << x;
    }
}

TEST(FillStrokes, DrawsThePartsOfAPictureLikeTheWhole)
{
    ui::StrokeMesh mesh;
    ui::addLine(mesh, {{{3.0, 2.0}, {255, 255, 255}}, {{40.0, 55.0}, {90, 255, 255}}, {{61.0, 20.0}, {9, 9, 255}}},
                {5.0, 0.7, 3.0});
    Sheet whole(64, 60);
    ui::fillStrokes(mesh, 60.0, whole.canvas());
    Sheet lower(64, 25);
    ui::fillStrokes(mesh, 25.0, lower.canvas());   // rows 35 … 59 of the whole image
    test::forEachPixel(64, 25, [&](int x, int y) { EXPECT_NEAR(lower.redAt(x, y), whole.redAt(x, y + 35), 1); });
}

TEST(FillStrokes, LeavesOutWhatLiesFarOffTheCanvas)
{
    ui::StrokeMesh mesh;
    addVertex(mesh, -3e9F, -3e9F, 255, 255);
    addVertex(mesh, -3e9F, -2e9F, 255, 255);
    addVertex(mesh, -2e9F, -3e9F, 255, 255);
    mesh.triangles = {0, 1, 2};
    Sheet sheet(8, 8);
    ui::fillStrokes(mesh, 8.0, sheet.canvas());
    EXPECT_EQ(sheet.pixels, std::vector<std::uint32_t>(64, black));
}

}   // namespace
