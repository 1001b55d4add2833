#include "ui/views/corner_blocks.h"

#include "ui/views/shadowed_text.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <optional>
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

/// Elides lines that are wider than `widthPx`.
QStringList fitted(QStringList lines, const QFont& font, double widthPx)
{
    const QFontMetricsF metrics(font);
    for (QString& line : lines) {
        line = metrics.elidedText(line, Qt::ElideRight, widthPx);
    }
    return lines;
}

/// Moves a block toward the middle of its edge if it would overlap the block `occupied`.
QRectF clearOf(const QRectF& occupied, QRectF block, Corner corner)
{
    constexpr double gap = 6.0;
    if (occupied.adjusted(-gap, -gap, gap, gap).intersects(block)) {
        block.translate(
            0.0, isBottom(corner) ? occupied.top() - gap - block.bottom() : occupied.bottom() + gap - block.top());
    }
    return block;
}

struct Block {
    Corner corner;
    QStringList lines;
    QFont font;
    QRectF rect;
};

/// Returns the block with its layout; nullopt if it would cover vessels, other items or (at full font size) the image.
std::optional<Block> placed(const QSizeF& size, Corner corner, const QStringList& lines, const QFont& font,
                            const ViewContent& content, const QRectF& occupied)
{
    const QStringList shown = fitted(lines, font, size.width() - 2.0 * annotationMarginPx);
    const QRectF rect = clearOf(occupied, blockRect(size, corner, shown, font), corner);
    const bool coversImage = font.pixelSize() == fullSizePx && content.hasImage(rect);
    if (coversImage || content.isTaken(rect) || content.hasVessels(rect)) {
        return std::nullopt;
    }
    return Block{corner, shown, font, rect};
}

void paint(QPainter& painter, const Block& block)
{
    painter.setFont(block.font);
    const int flags = (isRight(block.corner) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter | Qt::TextSingleLine;
    const double height = lineHeight(block.font);
    for (int i = 0; i < block.lines.size(); ++i) {
        const QRectF box(block.rect.left() - 2.0, block.rect.top() + i * height, block.rect.width() + 4.0, height);
        drawShadowedText(painter, box, flags, block.lines[i], colorOf(annotationTones().text));
    }
}

/// Lays out all blocks in one font size. If a block does not fit, returns nullopt unless `mayFold` is set: then the
/// block collapses to one line or is omitted.
std::optional<std::vector<Block>> layOut(const QSizeF& size, const CornerLines& lines, const QFont& font,
                                         const ViewContent& content, const QRectF& mode, bool mayFold)
{
    std::vector<Block> blocks;
    std::array<QRectF, 4> places;
    for (const Corner corner : {Corner::TopLeft, Corner::TopRight, Corner::BottomRight, Corner::BottomLeft}) {
        const QStringList& own = lines[static_cast<std::size_t>(corner)];
        if (own.isEmpty()) {
            continue;
        }
        const QRectF beside = corner == Corner::TopRight     ? places[0].united(mode)
                              : corner == Corner::BottomLeft ? places[static_cast<std::size_t>(Corner::BottomRight)]
                              : corner == Corner::TopLeft    ? mode
                                                             : QRectF();
        auto block = placed(size, corner, own, font, content, beside);
        if (!block && !mayFold) {
            return std::nullopt;
        }
        if (!block) {
            block = placed(size, corner, {isBottom(corner) ? own.back() : own.front()}, font, content, beside);
        }
        if (block) {
            places[static_cast<std::size_t>(corner)] = block->rect;
            blocks.push_back(std::move(*block));
        }
    }
    return blocks;
}

}   // namespace

std::array<QRectF, 4> paintCorners(QPainter& painter, const QSizeF& size, const CornerLines& lines,
                                   const ViewContent& content, const QRectF& mode)
{
    auto blocks = layOut(size, lines, withPixelSize(painter.font(), fullSizePx), content, mode, false);
    if (!blocks) {
        blocks = layOut(size, lines, withPixelSize(painter.font(), smallSizePx), content, mode, true);
    }
    std::array<QRectF, 4> places;
    for (const Block& block : *blocks) {
        paint(painter, block);
        places[static_cast<std::size_t>(block.corner)] = block.rect;
    }
    return places;
}

}   // namespace angiopose::ui
