#include "ui/views/corner_blocks.h"

#include "ui/views/shadowed_text.h"

#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double lineSpacing = 1.32;
constexpr int fullSizePx = 12;
constexpr int smallSizePx = 10;

bool isRight(Corner corner)
{
    return corner == Corner::TopRight || corner == Corner::BottomRight;
}

bool isBottom(Corner corner)
{
    return corner == Corner::BottomLeft || corner == Corner::BottomRight;
}

double lineHeight(const QFont& font)
{
    return std::round(lineSpacing * font.pixelSize());
}

QRectF blockRect(const QSizeF& size, Corner corner, const QStringList& lines, const QFont& font)
{
    const QFontMetricsF metrics(font);
    double width = 0.0;
    for (const QString& line : lines) {
        width = std::max(width, metrics.horizontalAdvance(line));
    }
    const double height = lineHeight(font) * static_cast<double>(lines.size());
    const double x = isRight(corner) ? size.width() - annotationMarginPx - width : annotationMarginPx;
    const double y = isBottom(corner) ? size.height() - annotationMarginPx - height : annotationMarginPx;
    return {x, y, width, height};
}

/// Lines that would reach out of the image end in dots.
QStringList fitted(QStringList lines, const QFont& font, double widthPx)
{
    const QFontMetricsF metrics(font);
    for (QString& line : lines) {
        line = metrics.elidedText(line, Qt::ElideRight, widthPx);
    }
    return lines;
}

/// The block, moved towards the middle where the opposite corner has taken its place.
QRectF clearOf(const QRectF& taken, QRectF block, Corner corner)
{
    constexpr double gap = 6.0;
    if (taken.adjusted(-gap, -gap, gap, gap).intersects(block)) {
        block.translate(0.0,
                        isBottom(corner) ? taken.top() - gap - block.bottom() : taken.bottom() + gap - block.top());
    }
    return block;
}

}   // namespace

QRectF paintCorner(QPainter& painter, const QSizeF& size, Corner corner, const QStringList& lines, const Ground& ground,
                   const QRectF& taken)
{
    if (lines.isEmpty()) {
        return {};
    }
    const QFont full = sized(painter.font(), fullSizePx);
    const QFont small = sized(painter.font(), smallSizePx);
    const QStringList folded{isBottom(corner) ? lines.back() : lines.front()};
    const std::array<std::pair<QStringList, QFont>, 3> choices{{{lines, full}, {lines, small}, {folded, small}}};
    for (const auto& [whole, font] : choices) {
        const QStringList shown = fitted(whole, font, size.width() - 2.0 * annotationMarginPx);
        const QRectF block = clearOf(taken, blockRect(size, corner, shown, font), corner);
        const bool coversPicture = ground.hasPicture(block);
        if (ground.isTaken(block) || ground.hasVessels(block) || (coversPicture && font == full)) {
            continue;
        }
        painter.setFont(font);
        const int flags = (isRight(corner) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter | Qt::TextSingleLine;
        for (int i = 0; i < shown.size(); ++i) {
            const QRectF box(block.left() - 2.0, block.top() + i * lineHeight(font), block.width() + 4.0,
                             lineHeight(font));
            drawShadowedText(painter, box, flags, shown[i], colorOf(annotationTones().text));
        }
        return block;
    }
    return {};
}

}   // namespace angiopose::ui