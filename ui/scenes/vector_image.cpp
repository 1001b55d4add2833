#include "ui/scenes/vector_image.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace angiopose::ui {
namespace {

/// Cutout in pixel coordinates of the exported image, y up.
struct CutoutInPicture {
    Cutout::Shape shape = Cutout::Shape::None;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    double radius = 0.0;

    bool contains(const Eigen::Vector2d& position) const
    {
        return shape == Cutout::Shape::RightOf ? position.x() > at.x()
               : shape == Cutout::Shape::Disc  ? (position - at).norm() < radius
                                               : false;
    }
};

CutoutInPicture inPicture(const Cutout& cutout, const VectorImage& picture, const ViewRect& part)
{
    const double scale = picture.width / part.width();
    return {cutout.shape,
            {(cutout.at.x() - part.left) * scale, (part.bottom - cutout.at.y()) * picture.height / part.height()},
            cutout.radiusPx * scale};
}

struct HiddenSpan {
    double from = 1.0;
    double to = 0.0;

    bool isEmpty() const { return from >= to; }
};

/// Returns the fractions of a→b between which the segment lies inside the cutout.
HiddenSpan insideCutout(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const CutoutInPicture& cutout)
{
    const Eigen::Vector2d step = b - a;
    if (cutout.shape == Cutout::Shape::RightOf) {
        if (step.x() == 0.0) {
            return cutout.contains(a) ? HiddenSpan{0.0, 1.0} : HiddenSpan{};
        }
        const double crossing = (cutout.at.x() - a.x()) / step.x();
        return step.x() > 0.0 ? HiddenSpan{std::max(0.0, crossing), 1.0} : HiddenSpan{0.0, std::min(1.0, crossing)};
    }
    const double length2 = step.squaredNorm();
    if (cutout.shape == Cutout::Shape::None || length2 == 0.0) {
        return {};
    }
    const double middle = (cutout.at - a).dot(step) / length2;
    const double off2 = (a + middle * step - cutout.at).squaredNorm();
    const double half2 = (cutout.radius * cutout.radius - off2) / length2;
    if (half2 <= 0.0) {
        return {};
    }
    return {std::max(0.0, middle - std::sqrt(half2)), std::min(1.0, middle + std::sqrt(half2))};
}

StrokePoint onSegment(const StrokePoint& a, const StrokePoint& b, double fraction)
{
    return {a.at + fraction * (b.at - a.at), mixed(a.color, b.color, fraction)};
}

std::vector<StrokeLine> outsideParts(const StrokeLine& line, const CutoutInPicture& cutout)
{
    std::vector<StrokeLine> parts(1);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const StrokePoint& a = line[i - 1];
        const StrokePoint& b = line[i];
        const HiddenSpan hiddenPart = insideCutout(a.at, b.at, cutout);
        if (parts.back().empty() && (hiddenPart.isEmpty() || hiddenPart.from > 0.0)) {
            parts.back().push_back(a);
        }
        if (hiddenPart.isEmpty()) {
            parts.back().push_back(b);
            continue;
        }
        if (hiddenPart.from > 0.0) {
            parts.back().push_back(onSegment(a, b, hiddenPart.from));
        }
        parts.emplace_back();
        if (hiddenPart.to < 1.0) {
            parts.back() = {onSegment(a, b, hiddenPart.to), b};
        }
    }
    std::erase_if(parts, [](const StrokeLine& part) { return part.size() < 2; });
    return parts;
}

/// Returns the sections of a ribbon in which both edges are visible.
std::vector<StrokeShape> ribbonParts(const StrokeShape& ribbon, const CutoutInPicture& cutout)
{
    const StrokeShape empty{ribbon.kind, {}, {}, ribbon.pen};
    std::vector<StrokeShape> parts{empty};
    for (std::size_t i = 0; i < std::min(ribbon.line.size(), ribbon.other.size()); ++i) {
        if (cutout.contains(ribbon.line[i].at) || cutout.contains(ribbon.other[i].at)) {
            parts.push_back(empty);
            continue;
        }
        parts.back().line.push_back(ribbon.line[i]);
        parts.back().other.push_back(ribbon.other[i]);
    }
    std::erase_if(parts, [](const StrokeShape& outsideShape) { return outsideShape.line.size() < 2; });
    return parts;
}

bool isInPicture(const Eigen::Vector2d& at, const VectorImage& picture)
{
    return at.x() >= 0.0 && at.y() >= 0.0 && at.x() <= picture.width && at.y() <= picture.height;
}

std::vector<StrokeShape> lineParts(const StrokeShape& shape, const VectorImage& picture, const CutoutInPicture& cutout)
{
    if (shape.line.size() < 2) {   // a single point is a dot of a dotted line
        const bool isVisible = !shape.line.empty() && isInPicture(shape.line.front().at, picture) &&
                               !cutout.contains(shape.line.front().at);
        return isVisible ? std::vector{shape} : std::vector<StrokeShape>{};
    }
    std::vector<StrokeShape> parts;
    for (const StrokeLine& visible : clipLine(shape.line, {0.0, 0.0}, {picture.width, picture.height})) {
        for (StrokeLine& line : outsideParts(visible, cutout)) {
            parts.push_back({shape.kind, std::move(line), {}, shape.pen});
        }
    }
    return parts;
}

/// Returns the edge of the cutout, with the same appearance as in raster images.
std::vector<StrokeShape> rimOf(const CutoutInPicture& cutout, const VectorImage& picture)
{
    constexpr int corners = 180;
    const Color tone = palette(ThemeMode::Dark).label;
    StrokeLine rim;
    if (cutout.shape == Cutout::Shape::RightOf) {
        rim = {{{cutout.at.x(), 0.0}, tone}, {{cutout.at.x(), 1.0 * picture.height}, tone}};
    }
    for (int i = 0; cutout.shape == Cutout::Shape::Disc && i <= corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        rim.push_back({cutout.at + cutout.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)), tone});
    }
    return lineParts({StrokeShape::Kind::Line, rim, {}, {.widthPx = 1.0}}, picture, {});
}

}   // namespace

std::vector<StrokeShape> visibleShapes(const std::vector<StrokeShape>& shapes, const VectorImage& picture,
                                       const Cutout& cutout, const ViewRect& part)
{
    const CutoutInPicture hiddenPart = inPicture(cutout, picture, part);
    std::vector<StrokeShape> visible;
    for (const StrokeShape& shape : shapes) {
        std::ranges::move(shape.kind == StrokeShape::Kind::Ribbon ? ribbonParts(shape, hiddenPart)
                                                                  : lineParts(shape, picture, hiddenPart),
                          std::back_inserter(visible));
    }
    std::ranges::move(rimOf(hiddenPart, picture), std::back_inserter(visible));
    return visible;
}

VectorImage joinSideBySide(VectorImage left, const VectorImage& right, int gap)
{
    const double shift = left.width + gap;
    for (VectorBackdrop backdrop : right.backdrops) {
        backdrop.left += shift;
        left.backdrops.push_back(std::move(backdrop));
    }
    for (StrokeShape shape : right.shapes) {
        for (StrokeLine* line : {&shape.line, &shape.other}) {
            for (StrokePoint& point : *line) {
                point.at.x() += shift;
            }
        }
        left.shapes.push_back(std::move(shape));
    }
    for (VectorFill fill : right.fills) {
        fill.rect.left += shift;
        fill.rect.right += shift;
        left.fills.push_back(fill);
    }
    for (VectorText text : right.texts) {
        text.at.x() += shift;
        left.texts.push_back(std::move(text));
    }
    left.width += gap + right.width;
    return left;
}

}   // namespace angiopose::ui
