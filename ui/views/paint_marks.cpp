#include "ui/views/paint_marks.h"

#include "ui/views/shadowed_text.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace angiopose::ui {
namespace {

void paintMarkLine(QPainter& painter, const PixelLine& line, const QColor& tone)
{
    QPolygonF points;
    for (const Eigen::Vector2d& at : line) {
        points << QPointF(at.x(), at.y());
    }
    painter.setPen(QPen(colorOf(annotationTones().canvas, 0.6), 3.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(points);
    painter.setPen(QPen(tone, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(points);
}

void paintMarkLabel(QPainter& painter, const QString& text, const Eigen::Vector2d& at, const QColor& tone)
{
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text) + 2.0, metrics.height());
    const auto inside = [](double wanted, double most) { return std::clamp(wanted, 2.0, std::max(2.0, most - 2.0)); };
    const QPointF place(inside(at.x(), painter.device()->width() - size.width()),
                        inside(at.y(), painter.device()->height() - size.height()));
    drawShadowedText(painter, QRectF(place, size), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, text, tone);
}

}   // namespace

void paintMarks(QPainter& painter, const std::vector<ImageMark>& marks, const MarkPlace& placeOf)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setFont(sized(painter.font(), 12));
    for (const ImageMark& mark : marks) {
        const QColor tone = colorOf(mark.isChosen ? annotationTones().accent : annotationTones().textStrong);
        for (const PixelLine& line : linesOf(mark, placeOf, markSizePx)) {
            paintMarkLine(painter, line, tone);
        }
        if (!mark.label.empty()) {
            paintMarkLabel(painter, QString::fromStdString(mark.label), labelPlace(mark, placeOf, markSizePx), tone);
        }
    }
    painter.restore();
}

void paintHandle(QPainter& painter, const Eigen::Vector2d& at, bool isHeld)
{
    painter.setPen(QPen(colorOf(annotationTones().canvas, 0.7), 1.0));
    painter.setBrush(colorOf(isHeld ? annotationTones().attention : annotationTones().accent));
    painter.drawEllipse(QPointF(at.x(), at.y()), 3.5, 3.5);
}

}   // namespace angiopose::ui
