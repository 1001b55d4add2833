#include "ui/scenes/image_mark.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::ui {
namespace {

std::optional<Eigen::Vector2d> wayBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const double length = (to - from).norm();
    return length > 0.0 ? std::optional<Eigen::Vector2d>((to - from) / length) : std::nullopt;
}

/// A bar across the line from `inner` to its end.
void addEndBar(std::vector<PixelLine>& lines, const Eigen::Vector2d& inner, const Eigen::Vector2d& end, double sizePx)
{
    if (const auto way = wayBetween(inner, end)) {
        const Eigen::Vector2d across(-way->y(), way->x());
        lines.push_back({end - sizePx * across, end + sizePx * across});
    }
}

/// The way round from one leg to the other, the shorter one.
void addArc(std::vector<PixelLine>& lines, const PixelLine& legs, double sizePx)
{
    const auto one = wayBetween(legs[1], legs[0]);
    const auto other = wayBetween(legs[1], legs[2]);
    if (!one || !other) {
        return;
    }
    const double shortest = std::min((legs[0] - legs[1]).norm(), (legs[2] - legs[1]).norm());
    const double radius = std::min(3.0 * sizePx, 0.6 * shortest);
    const double turn = std::atan2(one->x() * other->y() - one->y() * other->x(), one->dot(*other));
    constexpr int steps = 16;
    PixelLine arc;
    for (int i = 0; i <= steps; ++i) {
        const double angle = turn * i / steps;
        arc.emplace_back(legs[1] + radius * Eigen::Vector2d(std::cos(angle) * one->x() - std::sin(angle) * one->y(),
                                                            std::sin(angle) * one->x() + std::cos(angle) * one->y()));
    }
    lines.push_back(std::move(arc));
}

}   // namespace

std::vector<PixelLine> linesOf(const ImageMark& mark, const MarkPlace& placeOf, double sizePx)
{
    PixelLine line;
    for (const Eigen::Vector2d& pixel : mark.pixels) {
        line.push_back(placeOf(pixel));
    }
    if (line.size() < 2) {
        return {};
    }
    std::vector<PixelLine> lines{line};
    switch (mark.shape) {
        case MarkShape::Length:
            addEndBar(lines, line[1], line.front(), sizePx);
            addEndBar(lines, line[line.size() - 2], line.back(), sizePx);
            break;
        case MarkShape::Angle:
            if (line.size() == 3) {
                addArc(lines, line, sizePx);
            }
            break;
        case MarkShape::Outline:
            lines.front().push_back(line.front());
            break;
    }
    return lines;
}

Eigen::Vector2d labelPlace(const ImageMark& mark, const MarkPlace& placeOf, double sizePx)
{
    if (mark.pixels.empty()) {
        return Eigen::Vector2d::Zero();
    }
    const bool isAtVertex = mark.shape == MarkShape::Angle && mark.pixels.size() > 1;
    return placeOf(isAtVertex ? mark.pixels[1] : mark.pixels.back()) + 1.6 * Eigen::Vector2d(sizePx, sizePx);
}

}   // namespace angiopose::ui
