#include "ui/views/roll_cursor.h"

#include "ui/theme/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace angiopose::ui {
namespace {

constexpr int sizePx = 26;

QPainterPath arrowHead(const QPointF& tip, const QPointF& back, const QPointF& aside)
{
    QPainterPath head(tip);
    head.lineTo(tip + back + aside);
    head.lineTo(tip + back - aside);
    head.closeSubpath();
    return head;
}

}   // namespace

QCursor rollCursor()
{
    QPixmap picture(sizePx, sizePx);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const Color strong = palette(ThemeMode::Dark).textStrong;
    const QColor light(strong.red, strong.green, strong.blue);
    QPainterPath arc;
    const QRectF circle(5.0, 5.0, 16.0, 16.0);
    arc.arcMoveTo(circle, 25.0);
    arc.arcTo(circle, 25.0, 130.0);
    arc.arcMoveTo(circle, 205.0);
    arc.arcTo(circle, 205.0, 130.0);
    const QPainterPath heads =
        arrowHead({22.0, 15.0}, {-0.5, -6.0}, {4.0, 0.5}).united(arrowHead({4.0, 11.0}, {0.5, 6.0}, {4.0, 0.5}));
    painter.strokePath(arc, QPen(Qt::black, 4.5));
    painter.strokePath(heads, QPen(Qt::black, 2.0));
    painter.strokePath(arc, QPen(light, 2.0));
    painter.fillPath(heads, light);
    painter.end();
    return QCursor(picture, sizePx / 2, sizePx / 2);
}

}   // namespace angiopose::ui