#include "ui/scenes/stroke_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::ui {
namespace {

constexpr double sharpTurnCosine = 0.5;   // sharper turns than 60° get a round joint instead of a miter

/// Half widths and opacity across a stroke, which is solid up to `inner` and fully faded at `outer`.
struct Profile {
    double inner;
    double outer;
    double opacity;
};

Profile profileOf(const Pen& pen)
{
    const double half = 0.5 * pen.widthPx;
    const double fade = 0.5 * pen.fadePx;
    if (half >= fade) {
        return {half - fade, half + fade, pen.opacity};
    }
    return {0.0, half + fade,
            pen.opacity * 2.0 * half / (half + fade)};   // lines narrower than their soft edge become fainter
}

std::int32_t addVertex(StrokeMesh& mesh, const Eigen::Vector2d& at, const Color& color, double opacity)
{
    mesh.points.insert(mesh.points.end(), {static_cast<float>(at.x()), static_cast<float>(at.y()), 0.0F});
    const auto alpha = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0)));
    mesh.colors.insert(mesh.colors.end(), {color.red, color.green, color.blue, alpha});
    return static_cast<std::int32_t>(mesh.vertexCount()) - 1;
}

/// Adds four vertices across the line, from left to right: transparent, solid, solid, transparent.
std::int32_t addCrossSection(StrokeMesh& mesh, const StrokePoint& point, const Eigen::Vector2d& left,
                             const Profile& profile)
{
    const std::int32_t first = addVertex(mesh, point.at + profile.outer * left, point.color, 0.0);
    addVertex(mesh, point.at + profile.inner * left, point.color, profile.opacity);
    addVertex(mesh, point.at - profile.inner * left, point.color, profile.opacity);
    addVertex(mesh, point.at - profile.outer * left, point.color, 0.0);
    return first;
}

void joinCrossSections(StrokeMesh& mesh, std::int32_t a, std::int32_t b)
{
    for (std::int32_t side = 0; side < 3; ++side) {
        const std::int32_t p = a + side;
        const std::int32_t q = b + side;
        mesh.triangles.insert(mesh.triangles.end(), {p, q, p + 1, p + 1, q, q + 1});
    }
}

/// Adds a circular sector that starts at `startRad` and spans `sweepRad`, with the cross profile of the line.
void addSector(StrokeMesh& mesh, const StrokePoint& center, double startRad, double sweepRad, const Profile& profile)
{
    const int steps =
        std::clamp(static_cast<int>(std::ceil(std::abs(sweepRad) * std::sqrt(profile.outer + 1.0))), 4, 48);
    const std::int32_t middle = addVertex(mesh, center.at, center.color, profile.opacity);
    for (int k = 0; k <= steps; ++k) {
        const double angle = startRad + sweepRad * k / steps;
        const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
        const std::int32_t inner = addVertex(mesh, center.at + profile.inner * ray, center.color, profile.opacity);
        const std::int32_t outer = addVertex(mesh, center.at + profile.outer * ray, center.color, 0.0);
        if (k > 0) {
            mesh.triangles.insert(mesh.triangles.end(),
                                  {middle, inner - 2, inner, inner - 2, outer - 2, inner, inner, outer - 2, outer});
        }
    }
}

Eigen::Vector2d leftOf(const Eigen::Vector2d& direction)
{
    return {-direction.y(), direction.x()};
}

double angleOf(const Eigen::Vector2d& direction)
{
    return std::atan2(direction.y(), direction.x());
}

StrokeLine withoutRepeats(const StrokeLine& line)
{
    StrokeLine result;
    for (const StrokePoint& point : line) {
        if (result.empty() || (point.at - result.back().at).squaredNorm() > 1e-12) {
            result.push_back(point);
        }
    }
    return result;
}

/// Fills the outer side of a sharp corner between two straight segments.
void addRoundJoint(StrokeMesh& mesh, const StrokePoint& corner, const Eigen::Vector2d& in, const Eigen::Vector2d& out,
                   const Profile& profile)
{
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    const Eigen::Vector2d start = turn > 0.0 ? Eigen::Vector2d(-leftOf(in)) : leftOf(in);
    addSector(mesh, corner, angleOf(start), turn, profile);
}

StrokePoint between(const StrokePoint& a, const StrokePoint& b, double fraction)
{
    return {a.at + fraction * (b.at - a.at), mixed(a.color, b.color, fraction)};
}

/// Fractions of a→b between which the segment lies inside a box (Liang and Barsky 1984); none does if `from` > `to`.
struct MeshSpan {
    double from = 0.0;
    double to = 1.0;
};

MeshSpan insideBox(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& lower,
                   const Eigen::Vector2d& upper)
{
    MeshSpan span;
    for (int axis = 0; axis < 2; ++axis) {
        const double step = b[axis] - a[axis];
        if (step == 0.0) {
            if (a[axis] < lower[axis] || a[axis] > upper[axis]) {
                return {1.0, 0.0};
            }
            continue;
        }
        const double t0 = (lower[axis] - a[axis]) / step;
        const double t1 = (upper[axis] - a[axis]) / step;
        span.from = std::max(span.from, std::min(t0, t1));
        span.to = std::min(span.to, std::max(t0, t1));
    }
    return span;
}

}   // namespace

void StrokeMesh::clear()
{
    points.clear();
    colors.clear();
    triangles.clear();
}

void addLine(StrokeMesh& mesh, const StrokeLine& raw, const Pen& pen)
{
    const StrokeLine line = withoutRepeats(raw);
    if (line.empty()) {
        return;
    }
    if (mesh.shapes) {
        mesh.shapes->push_back({StrokeShape::Kind::Line, line, {}, pen});
        return;
    }
    if (line.size() == 1) {
        addDot(mesh, line.front(), 0.5 * pen.widthPx, pen.opacity);
        return;
    }
    const Profile profile = profileOf(pen);
    Eigen::Vector2d in = (line[1].at - line[0].at).normalized();
    addSector(mesh, line.front(), angleOf(leftOf(in)), std::numbers::pi, profile);
    std::int32_t last = addCrossSection(mesh, line.front(), leftOf(in), profile);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Eigen::Vector2d out = (line[i + 1].at - line[i].at).normalized();
        if (in.dot(out) > sharpTurnCosine) {
            const Eigen::Vector2d bisector = (leftOf(in) + leftOf(out)).normalized();
            const std::int32_t next = addCrossSection(mesh, line[i], bisector / bisector.dot(leftOf(in)), profile);
            joinCrossSections(mesh, last, next);
            last = next;
        } else {
            joinCrossSections(mesh, last, addCrossSection(mesh, line[i], leftOf(in), profile));
            addRoundJoint(mesh, line[i], in, out, profile);
            last = addCrossSection(mesh, line[i], leftOf(out), profile);
        }
        in = out;
    }
    joinCrossSections(mesh, last, addCrossSection(mesh, line.back(), leftOf(in), profile));
    addSector(mesh, line.back(), angleOf(leftOf(in)), -std::numbers::pi, profile);
}

void addDot(StrokeMesh& mesh, const StrokePoint& center, double radiusPx, double opacity)
{
    if (mesh.shapes) {
        mesh.shapes->push_back({StrokeShape::Kind::Line, {center}, {}, {2.0 * radiusPx, opacity, 1.0}});
        return;
    }
    addSector(mesh, center, 0.0, 2.0 * std::numbers::pi, profileOf({2.0 * radiusPx, opacity, 1.0}));
}

void addRibbon(StrokeMesh& mesh, const StrokeLine& left, const StrokeLine& right, double opacity)
{
    if (mesh.shapes) {
        mesh.shapes->push_back({StrokeShape::Kind::Ribbon, left, right, {.opacity = opacity}});
        return;
    }
    const std::size_t count = std::min(left.size(), right.size());
    for (std::size_t i = 0; i < count; ++i) {
        addVertex(mesh, left[i].at, left[i].color, opacity);
        const std::int32_t last = addVertex(mesh, right[i].at, left[i].color, opacity);
        if (i > 0) {
            mesh.triangles.insert(mesh.triangles.end(), {last - 3, last - 2, last - 1, last - 1, last - 2, last});
        }
    }
}

std::vector<StrokeLine> clipLine(const StrokeLine& line, const Eigen::Vector2d& lower, const Eigen::Vector2d& upper)
{
    std::vector<StrokeLine> parts;
    bool isOpen = false;   // true if the last part continues in the next segment
    for (std::size_t i = 1; i < line.size(); ++i) {
        const MeshSpan span = insideBox(line[i - 1].at, line[i].at, lower, upper);
        if (span.from > span.to) {
            isOpen = false;
            continue;
        }
        if (!isOpen || span.from > 0.0) {
            parts.push_back({between(line[i - 1], line[i], span.from)});
        }
        parts.back().push_back(between(line[i - 1], line[i], span.to));
        isOpen = span.to >= 1.0;
    }
    return parts;
}

std::vector<StrokeLine> splitIntoDashes(const StrokeLine& line, const DashPattern& pattern)
{
    std::vector<StrokeLine> parts;
    bool isDrawing = true;
    double left = pattern.dashPx;
    if (!line.empty()) {
        parts.push_back({line.front()});
    }
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double length = (line[i].at - line[i - 1].at).norm();
        double done = 0.0;
        while (length - done > left) {
            done += left;
            const StrokePoint change = between(line[i - 1], line[i], done / length);
            if (isDrawing) {
                parts.back().push_back(change);
            } else {
                parts.push_back({change});
            }
            isDrawing = !isDrawing;
            left = isDrawing ? pattern.dashPx : pattern.gapPx;
        }
        left -= length - done;
        if (isDrawing) {
            parts.back().push_back(line[i]);
        }
    }
    return parts;
}

StrokeLine thinLine(const StrokeLine& line, double minimumStepPx)
{
    StrokeLine result;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool isEnd = i == 0 || i + 1 == line.size();
        if (isEnd || (line[i].at - result.back().at).norm() >= minimumStepPx) {
            result.push_back(line[i]);
        }
    }
    return result;
}

}   // namespace angiopose::ui
