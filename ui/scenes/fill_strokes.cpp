#include "ui/scenes/fill_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

/// Vertex on the canvas: y points down, and pixel k spans k … k + 1.
struct StrokeCorner {
    float x, y;
    std::array<float, 4> rgba;
};

StrokeCorner cornerOf(const StrokeMesh& mesh, std::int32_t vertex, float top)
{
    const auto v = static_cast<std::size_t>(vertex);
    const std::uint8_t* rgba = mesh.colors.data() + 4 * v;
    return {mesh.points[3 * v],
            top - mesh.points[3 * v + 1],
            {static_cast<float>(rgba[0]), static_cast<float>(rgba[1]), static_cast<float>(rgba[2]),
             static_cast<float>(rgba[3]) / 255.0F}};
}

/// Returns the first pixel whose center is at or beyond `edge`.
int firstInside(float edge)
{
    constexpr float farPx = 1e6F;   // beyond any canvas but safely within the range of int
    return static_cast<int>(std::ceil(std::clamp(edge, -farPx, farPx) - 0.5F));
}

/// Returns the x coordinate of the edge a→b (a above b) at height y. Both triangles that share the edge compute the
/// value from the same vertices in the same order, hence bit-identically.
float crossing(const StrokeCorner& a, const StrokeCorner& b, float y)
{
    return a.x + (y - a.y) * ((b.x - a.x) / (b.y - a.y));
}

/// Color and opacity of a triangle as linear functions of the canvas position.
struct Shade {
    std::array<float, 4> perX, perY;
    StrokeCorner origin;

    std::array<float, 4> at(float x, float y) const
    {
        std::array<float, 4> value;
        for (std::size_t i = 0; i < 4; ++i) {
            value[i] = origin.rgba[i] + (x - origin.x) * perX[i] + (y - origin.y) * perY[i];
        }
        return value;
    }
};

Shade shadeOf(const StrokeCorner& a, const StrokeCorner& b, const StrokeCorner& c, float doubleArea)
{
    Shade shade{{}, {}, a};
    for (std::size_t i = 0; i < 4; ++i) {
        const float ab = b.rgba[i] - a.rgba[i];
        const float ac = c.rgba[i] - a.rgba[i];
        shade.perX[i] = (ab * (c.y - a.y) - ac * (b.y - a.y)) / doubleArea;
        shade.perY[i] = (ac * (b.x - a.x) - ab * (c.x - a.x)) / doubleArea;
    }
    return shade;
}

std::uint32_t blended(std::uint32_t under, const std::array<float, 4>& over)
{
    const float opacity = std::clamp(over[3], 0.0F, 1.0F);
    const auto mix = [opacity](std::uint32_t below, float above) {
        const auto ground = static_cast<float>(below & 0xFFU);
        return static_cast<std::uint32_t>(std::clamp(ground + opacity * (above - ground) + 0.5F, 0.0F, 255.0F));
    };
    return 0xFF000000U | (mix(under >> 16U, over[0]) << 16U) | (mix(under >> 8U, over[1]) << 8U) | mix(under, over[2]);
}

/// Fills a span of an opaque triangle without reading the background.
void coverSpan(const Shade& shade, std::array<float, 4> value, int from, int to, std::uint32_t* row)
{
    const auto channel = [](float tone) { return static_cast<std::uint32_t>(std::clamp(tone + 0.5F, 0.0F, 255.0F)); };
    for (int x = from; x < to; ++x) {
        row[x] = 0xFF000000U | (channel(value[0]) << 16U) | (channel(value[1]) << 8U) | channel(value[2]);
        for (std::size_t i = 0; i < 3; ++i) {
            value[i] += shade.perX[i];
        }
    }
}

void fillSpan(const Shade& shade, int y, int from, int to, Canvas canvas)
{
    std::array<float, 4> value = shade.at(static_cast<float>(from) + 0.5F, static_cast<float>(y) + 0.5F);
    std::uint32_t* row = canvas.row(y);
    if (value[3] == 1.0F && shade.perX[3] == 0.0F) {
        coverSpan(shade, value, from, to, row);
        return;
    }
    for (int x = from; x < to; ++x) {
        row[x] = blended(row[x], value);
        for (std::size_t i = 0; i < 4; ++i) {
            value[i] += shade.perX[i];
        }
    }
}

void fillTriangle(StrokeCorner a, StrokeCorner b, StrokeCorner c, Canvas canvas, const Rows& rows)
{
    if (b.y < a.y) {
        std::swap(a, b);
    }
    if (c.y < a.y) {
        std::swap(a, c);
    }
    if (c.y < b.y) {
        std::swap(b, c);
    }
    const int top = std::max(rows.from, firstInside(a.y));
    const int bottom = std::min(rows.to, firstInside(c.y));
    const float doubleArea = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (top >= bottom || std::abs(doubleArea) < 1e-9F) {
        return;
    }
    const Shade shade = shadeOf(a, b, c, doubleArea);
    for (int y = top; y < bottom; ++y) {
        const float center = static_cast<float>(y) + 0.5F;
        const float one = crossing(a, c, center);
        const float other = center < b.y ? crossing(a, b, center) : crossing(b, c, center);
        const int from = std::max(0, firstInside(std::min(one, other)));
        const int to = std::min(canvas.width, firstInside(std::max(one, other)));
        if (from < to) {
            fillSpan(shade, y, from, to, canvas);
        }
    }
}

/// Returns whether the triangle overlaps the height range `lower` … `upper`, measured upward from the mesh origin.
bool reaches(const StrokeMesh& mesh, const std::int32_t* triangle, float lower, float upper)
{
    const auto y = [&](int corner) { return mesh.points[3 * static_cast<std::size_t>(triangle[corner]) + 1]; };
    return !(y(0) < lower && y(1) < lower && y(2) < lower) && !(y(0) > upper && y(1) > upper && y(2) > upper);
}

}   // namespace

void fillStrokes(const StrokeMesh& mesh, double topOfMesh, Canvas canvas)
{
    fillStrokes(mesh, topOfMesh, canvas, {0, canvas.height});
}

void fillStrokes(const StrokeMesh& mesh, double topOfMesh, Canvas canvas, const Rows& rows)
{
    const auto top = static_cast<float>(topOfMesh);
    const float upper = top - static_cast<float>(rows.from) + 1.0F;
    const float lower = top - static_cast<float>(rows.to) - 1.0F;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        if (reaches(mesh, &mesh.triangles[i], lower, upper)) {
            fillTriangle(cornerOf(mesh, mesh.triangles[i], top), cornerOf(mesh, mesh.triangles[i + 1], top),
                         cornerOf(mesh, mesh.triangles[i + 2], top), canvas, rows);
        }
    }
}

}   // namespace angiopose::ui
