#include "ui/controls/glyph_button.h"

#include "ui/theme/active_theme.h"

#include <QPainter>
#include <QPainterPath>

namespace angiopose::ui {
namespace {

using Glyph = GlyphButton::Glyph;

/// Adds an arrowhead with its point at `tip`; `along` is the unit vector of its direction.
void addHead(QPainterPath& path, const QPointF& tip, const QPointF& along)
{
    constexpr double length = 3.2;
    const QPointF across(-along.y(), along.x());
    path.moveTo(tip - length * along + length * across);
    path.lineTo(tip);
    path.lineTo(tip - length * along - length * across);
}

/// Returns the outline of a glyph, centered on the origin and at most 12 px wide.
QPainterPath pathOf(Glyph glyph)
{
    QPainterPath path;
    switch (glyph) {
        case Glyph::Play:
            path.addPolygon(QPolygonF({{-3.5, -5.5}, {5.5, 0.0}, {-3.5, 5.5}, {-3.5, -5.5}}));
            break;
        case Glyph::Pause:
            path.addRect(-4.5, -5.0, 3.2, 10.0);
            path.addRect(1.3, -5.0, 3.2, 10.0);
            break;
        case Glyph::Loop:
            path.arcMoveTo(-5.0, -5.0, 10.0, 10.0, 40.0);
            path.arcTo(-5.0, -5.0, 10.0, 10.0, 40.0, 300.0);
            addHead(path, path.currentPosition(), {0.34, -0.94});
            break;
        case Glyph::BackAndForth:
            path.moveTo(-6.0, 0.0);
            path.lineTo(6.0, 0.0);
            addHead(path, {6.0, 0.0}, {1.0, 0.0});
            addHead(path, {-6.0, 0.0}, {-1.0, 0.0});
            break;
        case Glyph::Pin:
            path.addRect(-2.5, -5.5, 5.0, 5.0);
            path.moveTo(-4.5, -0.5);
            path.lineTo(4.5, -0.5);
            path.moveTo(0.0, -0.5);
            path.lineTo(0.0, 5.5);
            break;
        case Glyph::Remove:
            path.moveTo(-4.0, -4.0);
            path.lineTo(4.0, 4.0);
            path.moveTo(4.0, -4.0);
            path.lineTo(-4.0, 4.0);
            break;
    }
    return path;
}

bool isOpacified(Glyph glyph)
{
    return glyph == Glyph::Play || glyph == Glyph::Pause;
}

}   // namespace

GlyphButton::GlyphButton(Glyph glyph, QWidget* parent) : QToolButton(parent), glyph_(glyph) {}

void GlyphButton::showGlyph(Glyph glyph)
{
    glyph_ = glyph;
    update();
}

void GlyphButton::paintEvent(QPaintEvent* event)
{
    QToolButton::paintEvent(event);
    const Palette& colors = activePalette();
    const QColor tone = toQColor(!isEnabled()                  ? colors.hint
                                 : underMouse() || isChecked() ? colors.textStrong
                                                               : colors.text);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(QRectF(rect()).center());
    const bool isPinned = glyph_ == Glyph::Pin && isChecked();
    if (isPinned) {
        painter.fillPath(pathOf(glyph_), toQColor(colors.accent));
        painter.strokePath(pathOf(glyph_), QPen(toQColor(colors.accent), 1.5));
    } else if (isOpacified(glyph_)) {
        painter.fillPath(pathOf(glyph_), tone);
    } else {
        painter.strokePath(pathOf(glyph_), QPen(tone, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    }
}

}   // namespace angiopose::ui
