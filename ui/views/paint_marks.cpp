#include "ui/views/paint_marks.h"

#include "ui/views/shadowed_text.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <iterator>

namespace angiopose::ui {
namespace {

void paintMarkLine(QPainter& painter, const PixelLine& line, const QColor& tone, const Color& rim)
{
    QPolygonF points;
    for (const Eigen::Vector2d& at : line) {
        points << QPointF(at.x(), at.y());
    }
    painter.setPen(QPen(colorOf(rim, markRimOpacity), markRimWidthPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(points);
    painter.setPen(QPen(tone, markWidthPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(points);
}

QString wordsOf(const ImageMark& mark)
{
    return QString::fromStdString(mark.label);
}

std::vector<LabelRequest> wantedLabels(const QPainter& painter, const std::vector<ImageMark>& marks,
                                       const PixelMapping& positionOf)
{
    const QFontMetricsF metrics(painter.font());
    std::vector<LabelRequest> labels;
    for (const ImageMark& mark : marks) {
        LabelRequest& label = labels.emplace_back();
        label.at = labelAnchor(mark, positionOf);
        label.gapPx = 1.6 * markSizePx;
        if (!mark.label.empty()) {
            label.size = {metrics.horizontalAdvance(wordsOf(mark)) + 2.0, metrics.height()};
        }
    }
    return labels;
}

}   // namespace

void paintMarks(QPainter& painter, const std::vector<ImageMark>& marks, const PixelMapping& positionOf,
                MarkBackground background)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setFont(withPixelSize(painter.font(), 12));
    if (!(background.width > 0.0)) {
        const double ratio = painter.device()->devicePixelRatioF();
        const bool isPicture = painter.device()->devType() == QInternal::Image;   // QImage sizes are in device px
        background.width = painter.device()->width() / (isPicture ? ratio : 1.0);
        background.height = painter.device()->height() / (isPicture ? ratio : 1.0);
    }
    for (const ImageMark& mark : marks) {
        const std::vector<PixelLine> lines = markLines(mark, positionOf, markSizePx);
        std::ranges::copy(pointsAlong(lines, markSizePx), std::back_inserter(background.avoided));
        for (const PixelLine& line : background.hasLines ? std::vector<PixelLine>() : lines) {
            paintMarkLine(painter, line, colorOf(markColor(mark, background.colors)), background.rim);
        }
    }
    const std::vector<LabelRequest> labels = wantedLabels(painter, marks, positionOf);
    const std::vector<Eigen::Vector2d> corners = placeLabels(labels, background);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (!marks[i].label.empty()) {
            const QRectF box(corners[i].x(), corners[i].y(), labels[i].size.x(), labels[i].size.y());
            drawShadowedText(painter, box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, wordsOf(marks[i]),
                             colorOf(markColor(marks[i], background.colors)), background.rim);
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
