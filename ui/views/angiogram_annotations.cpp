#include "ui/views/angiogram_annotations.h"

#include "ui/scenes/residual_scale.h"
#include "ui/views/corner_blocks.h"
#include "ui/views/shadowed_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

/// Translation context for the strings in this file.
struct AnnotationWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::ui::AngiogramAnnotations)
};

QString number(double value)
{
    return numberText(value, std::abs(value) < 10.0 ? 2 : 0);
}

QStringList toLines(const std::vector<std::string>& texts)
{
    QStringList lines;
    for (const std::string& text : texts) {
        lines << QString::fromStdString(text);
    }
    return lines;
}

QStringList ownLines(const AngiogramAnnotations& annotations, double zoom)
{
    QStringList parts;
    if (!annotations.frameText.isEmpty()) {
        parts << annotations.frameText;
    }
    parts << QStringLiteral("W %1 L %2").arg(number(annotations.range.window()), number(annotations.range.level()));
    parts << QStringLiteral("%1 %").arg(qRound(100.0 * zoom));
    QStringList lines = toLines(annotations.texts.bottomLeft);
    if (!annotations.keyText.isEmpty()) {
        lines << annotations.keyText;
    }
    lines << parts.join(QStringLiteral(" · "));
    return lines;
}

double niceLength(double longestMm)
{
    double best = 0.0;
    for (const double length : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0}) {
        if (length <= longestMm) {
            best = length;
        }
    }
    return best;
}

/// Paints a ruler of a round length in mm at the depth of the vessels, above the text block in the lower left corner.
void paintRuler(QPainter& painter, const QSizeF& size, const QRectF& blockBelow, double pxPerMm)
{
    const double longestPx = std::min(140.0, 0.3 * size.width());
    const double lengthMm = niceLength(longestPx / pxPerMm);
    if (!(lengthMm > 0.0)) {
        return;
    }
    const double length = std::round(lengthMm * pxPerMm);
    const double bottom = blockBelow.isEmpty() ? size.height() - annotationMarginPx : blockBelow.top() - 10.0;
    const QRectF bar(annotationMarginPx, std::round(bottom) - 2.0, length, 2.0);
    const QColor shade = colorOf(annotationTones().canvas, 0.6);
    const QColor tone = colorOf(annotationTones().text);
    const auto fill = [&](const QRectF& rect) {
        painter.fillRect(rect.adjusted(-1.0, -1.0, 1.0, 1.0), shade);
        painter.fillRect(rect, tone);
    };
    fill(bar);
    for (int tick = 0; tick <= 5; ++tick) {
        const double x = std::min(bar.left() + std::round(length * tick / 5.0), bar.right() - 1.0);
        const double height = tick % 5 == 0 ? 7.0 : 4.0;
        fill(QRectF(x, bar.bottom() - height, 1.0, height));
    }
    painter.setFont(withPixelSize(painter.font(), 11));
    drawShadowedText(painter, QRectF(bar.left(), bar.top() - 22.0, 220.0, 16.0),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                     AnnotationWords::tr("%1 mm at vessel").arg(briefNumber(lengthMm, 6)), tone);
}

/// Returns the area that the residual scale covers, including its labels.
QRectF scaleArea(const QRectF& bar)
{
    return bar.adjusted(-58.0, -34.0, 6.0, 12.0);
}

/// Returns the rectangle of the residual scale: in the middle of the right edge, or the nearest position along the edge
/// at which it covers no vessels.
QRectF scaleBar(const QSizeF& size, const ViewContent& content, const std::vector<QRectF>& corners)
{
    const double height = std::round(std::clamp(0.2 * size.height(), 80.0, 180.0));
    const QRectF middle(size.width() - annotationMarginPx - 10.0, std::round(0.5 * (size.height() - height)), 10.0,
                        height);
    for (const double fraction : {0.0, 0.08, -0.08, 0.16, -0.16, 0.24, -0.24, 0.32, -0.32}) {
        const QRectF bar = middle.translated(0.0, std::round(fraction * size.height()));
        const QRectF scaleRect = scaleArea(bar);
        const auto meets = [&scaleRect](const QRectF& occupiedRect) { return occupiedRect.intersects(scaleRect); };
        const bool isInside = scaleRect.top() >= 0.0 && scaleRect.bottom() <= size.height();
        if (isInside && std::ranges::none_of(corners, meets) && !content.isTaken(scaleRect) &&
            !content.hasVessels(scaleRect)) {
            return bar;
        }
    }
    return middle;
}

void paintScale(QPainter& painter, const QRectF& bar, const AngiogramAnnotations& annotations)
{
    const bool inMm = annotations.scaleMaximumMm > 0.0;
    const double maximum = inMm ? annotations.scaleMaximumMm : annotations.scaleMaximumPx;
    painter.fillRect(bar.adjusted(-1.0, -10.0, 1.0, 1.0), colorOf(annotationTones().canvas, 0.6));

    QLinearGradient ramp(bar.bottomLeft(), bar.topLeft());
    for (int k = 0; k <= 8; ++k) {
        ramp.setColorAt(k / 8.0, colorOf(residualColor(k / 8.0)));
    }
    painter.fillRect(bar, ramp);
    painter.fillRect(QRectF(bar.left(), bar.top() - 9.0, bar.width(), 7.0), colorOf(residualColorAboveScale()));

    painter.setFont(withPixelSize(painter.font(), 11));
    const int flags = Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine;
    const auto label = [&](double y, const QString& text, const Color& tone) {
        drawShadowedText(painter, QRectF(bar.left() - 94.0, y - 8.0, 88.0, 16.0), flags, text, colorOf(tone));
    };
    const int decimals = residualScaleDecimals(maximum);
    const QString unit = inMm ? QStringLiteral("mm") : QStringLiteral("px");
    const QString heading = QString::fromStdString(annotations.texts.scaleHeading);
    label(bar.top() - 24.0, heading.isEmpty() ? unit : heading, annotationTones().label);
    label(bar.top() - 6.0, QStringLiteral("> %1").arg(numberText(maximum, decimals)), annotationTones().text);
    label(bar.center().y(), numberText(0.5 * maximum, decimals), annotationTones().text);
    label(bar.bottom() - 1.0, QStringLiteral("0"), annotationTones().text);
}

QFont modeFont(const QPainter& painter)
{
    return withPixelSize(painter.font(), 11);
}

/// Returns the bounding box of the bars in the upper half; empty if there are none.
QRectF barsOnTop(const QSizeF& size, const std::vector<QRectF>& bars)
{
    QRectF all;
    for (const QRectF& bar : bars) {
        all = bar.bottom() < 0.5 * size.height() ? all.united(bar) : all;
    }
    return all;
}

/// Returns the box of the mode label, centered at the top below the bars; empty without a mode.
QRectF modeBox(const QPainter& painter, const QSizeF& size, const ModeLabel& mode, const QRectF& bars)
{
    if (mode.text.isEmpty()) {
        return {};
    }
    const double width =
        std::min(QFontMetricsF(modeFont(painter)).horizontalAdvance(mode.text) + 16.0, size.width() - 12.0);
    return {0.5 * (size.width() - width), std::max(0.0, bars.bottom()) + 6.0, width, 20.0};
}

void paintMode(QPainter& painter, const QSizeF& size, const ModeLabel& mode, const QRectF& box)
{
    constexpr double border = 3.0;
    const QColor tone = colorOf(mode.tone);
    painter.fillRect(QRectF(0.0, 0.0, size.width(), border), tone);
    painter.fillRect(QRectF(0.0, size.height() - border, size.width(), border), tone);
    painter.fillRect(QRectF(0.0, 0.0, border, size.height()), tone);
    painter.fillRect(QRectF(size.width() - border, 0.0, border, size.height()), tone);
    painter.setFont(modeFont(painter));
    painter.fillRect(box, colorOf(annotationTones().canvas, 0.65));
    drawShadowedText(painter, box, Qt::AlignHCenter | Qt::AlignVCenter,
                     QFontMetricsF(painter.font()).elidedText(mode.text, Qt::ElideRight, box.width() - 8.0), tone);
}

/// Returns the y at which the top or bottom letter avoids the corner text, searched in small steps.
double clearHeight(double middle, double centerY, const std::vector<QRectF>& occupied, double step)
{
    const auto covers = [&](const QRectF& block) {
        return block.intersects(QRectF(middle - 10.0, centerY - 9.0, 20.0, 18.0));
    };
    const auto block = std::ranges::find_if(occupied, covers);
    return block == occupied.end() ? centerY : clearHeight(middle, centerY + step, occupied, step);
}

/// Returns the y of the orientation letter at the right edge: in the middle, or above or below the residual scale,
/// where it avoids the corner text.
double besideScale(const QSizeF& size, const QRectF& scale, const std::vector<QRectF>& occupied)
{
    if (scale.isEmpty()) {
        return 0.5 * size.height();
    }
    const double above = scale.top() - 56.0;
    const QRectF letter(size.width() - 40.0, above - 9.0, 40.0, 18.0);
    const bool isFree = std::ranges::none_of(occupied, [&](const QRectF& block) { return block.intersects(letter); });
    return isFree && letter.top() >= 0.0 ? above : scale.bottom() + 26.0;
}

/// Draws an orientation letter (patient's side) at the middle of every edge.
void paintSides(QPainter& painter, const QSizeF& size, const AngiogramAnnotations& annotations, const QRectF& scale,
                const std::vector<QRectF>& occupied)
{
    painter.setFont(withPixelSize(painter.font(), 12));
    const auto letter = [&painter](const QPointF& center, const std::string& text) {
        drawShadowedText(painter, QRectF(center - QPointF(20.0, 9.0), QSizeF(40.0, 18.0)), Qt::AlignCenter,
                         QString::fromStdString(text), colorOf(annotationTones().textStrong));
    };
    constexpr double step = 8.0;
    const double middle = 0.5 * size.width();
    const double below = clearHeight(middle, annotations.mode.text.isEmpty() ? 18.0 : 34.0, occupied, step);
    letter({middle, below}, annotations.sides.top);
    if (!annotations.sideMark.isEmpty()) {
        const double width = QFontMetricsF(painter.font()).horizontalAdvance(annotations.sideMark) + 16.0;
        painter.fillRect(QRectF(0.5 * (size.width() - width), below + 10.0, width, 18.0),
                         colorOf(annotationTones().canvas, 0.6));
        drawShadowedText(painter, QRectF(0.0, below + 10.0, size.width(), 18.0), Qt::AlignCenter, annotations.sideMark,
                         colorOf(annotationTones().attention));
    }
    letter({middle, clearHeight(middle, size.height() - 18.0, occupied, -step)}, annotations.sides.bottom);
    letter({20.0, 0.5 * size.height()}, annotations.sides.left);
    letter({size.width() - 20.0, besideScale(size, scale, occupied)}, annotations.sides.right);
}

}   // namespace

void paintAnnotations(QPainter& painter, const QSizeF& size, const AngiogramAnnotations& annotations,
                      const ImageViewport& viewport, const OverlayScene& scene)
{
    const ViewContent content(viewport, scene, annotations.occupied);
    const CornerTexts& texts = annotations.texts;
    const QRectF bars = barsOnTop(size, annotations.occupied);
    const QRectF mode = modeBox(painter, size, annotations.mode, bars);
    const CornerLines lines{toLines(texts.topLeft), toLines(texts.topRight), ownLines(annotations, viewport.zoom()),
                            toLines(texts.bottomRight)};
    const auto [topLeft, topRight, below, beside] = paintCorners(painter, size, lines, content, mode.united(bars));
    if (annotations.mmPerImagePx > 0.0) {
        paintRuler(painter, size, below, viewport.zoom() / annotations.mmPerImagePx);
    }
    const bool hasScale = annotations.scaleMaximumPx > 0.0 && !annotations.isScaleHidden;
    const QRectF scale = hasScale ? scaleBar(size, content, {topRight, beside}) : QRectF();
    paintSides(painter, size, annotations, scale, {topLeft, topRight, beside, below, mode.united(bars)});
    if (hasScale) {
        paintScale(painter, scale, annotations);
    }
    if (!annotations.mode.text.isEmpty()) {
        paintMode(painter, size, annotations.mode, mode);
    }
}

}   // namespace angiopose::ui
