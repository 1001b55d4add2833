#include "ui/scenes/image_mark.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace angiopose::ui {
namespace {

std::optional<Eigen::Vector2d> directionBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const double length = (to - from).norm();
    return length > 0.0 ? std::optional<Eigen::Vector2d>((to - from) / length) : std::nullopt;
}

/// Adds a bar across the end, `end`, of the segment that starts at `inner`.
void addEndBar(std::vector<PixelLine>& lines, const Eigen::Vector2d& inner, const Eigen::Vector2d& end, double sizePx)
{
    if (const auto direction = directionBetween(inner, end)) {
        const Eigen::Vector2d across(-direction->y(), direction->x());
        lines.push_back({end - sizePx * across, end + sizePx * across});
    }
}

/// Adds the shorter arc between the two legs of an angle.
void addArc(std::vector<PixelLine>& lines, const PixelLine& legs, double sizePx)
{
    const auto one = directionBetween(legs[1], legs[0]);
    const auto other = directionBetween(legs[1], legs[2]);
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

void addCircle(std::vector<PixelLine>& lines, const Eigen::Vector2d& at, double radius)
{
    constexpr int steps = 24;
    PixelLine circle;
    for (int i = 0; i <= steps; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / steps;
        circle.emplace_back(at + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    lines.push_back(std::move(circle));
}

void addCross(std::vector<PixelLine>& lines, const Eigen::Vector2d& at, double arm)
{
    lines.push_back({at - Eigen::Vector2d(arm, arm), at + Eigen::Vector2d(arm, arm)});
    lines.push_back({at + Eigen::Vector2d(-arm, arm), at + Eigen::Vector2d(arm, -arm)});
}

void addHead(std::vector<PixelLine>& lines, const Eigen::Vector2d& from, const Eigen::Vector2d& tip, double sizePx)
{
    if (const auto direction = directionBetween(from, tip)) {
        const Eigen::Vector2d across(-direction->y(), direction->x());
        const Eigen::Vector2d back = tip - 2.0 * sizePx * *direction;
        lines.push_back({back + sizePx * across, tip, back - sizePx * across});
    }
}

/// Returns the outline of a circle or cross at each point.
std::vector<PixelLine> signsOf(const ImageMark& mark, const PixelLine& places, double sizePx)
{
    std::vector<PixelLine> lines;
    for (const Eigen::Vector2d& at : places) {
        if (mark.shape == MarkShape::Point) {
            addCircle(lines, at, sizePx);
        } else {
            addCross(lines, at, 0.8 * sizePx);
        }
    }
    return lines;
}

}   // namespace

std::vector<PixelLine> markLines(const ImageMark& mark, const PixelMapping& positionOf, double sizePx)
{
    PixelLine line;
    for (const Eigen::Vector2d& pixel : mark.pixels) {
        line.push_back(positionOf(pixel));
    }
    if (mark.shape == MarkShape::Point || mark.shape == MarkShape::Cross) {
        return signsOf(mark, line, sizePx);
    }
    if (line.size() < 2 || mark.shape == MarkShape::Text) {
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
        case MarkShape::Arrow:
            addHead(lines, line[line.size() - 2], line.back(), 1.4 * sizePx);
            break;
        default:
            break;
    }
    return lines;
}

std::vector<Eigen::Vector2d> pointsAlong(const std::vector<PixelLine>& lines, double stepPx)
{
    std::vector<Eigen::Vector2d> points;
    for (const PixelLine& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const int steps = std::clamp(static_cast<int>((line[i] - line[i - 1]).norm() / stepPx), 1, 1000);
            for (int k = 0; k < steps; ++k) {
                points.emplace_back(line[i - 1] + (line[i] - line[i - 1]) * k / steps);
            }
        }
    }
    return points;
}

Eigen::Vector2d labelAnchor(const ImageMark& mark, const PixelMapping& positionOf)
{
    if (mark.pixels.empty()) {
        return Eigen::Vector2d::Zero();
    }
    const bool isAtVertex = mark.shape == MarkShape::Angle && mark.pixels.size() > 1;
    const bool isAtTail = mark.shape == MarkShape::Arrow || mark.shape == MarkShape::Text;
    return positionOf(isAtTail ? mark.pixels.front() : isAtVertex ? mark.pixels[1] : mark.pixels.back());
}

Color markColor(const ImageMark& mark, const Palette& colors)
{
    return mark.isSelected ? colors.accent : mark.tone == MarkTone::Place ? colors.fine : colors.textStrong;
}

}   // namespace angiopose::ui
