#pragma once

#include <QPen>
#include <QRectF>
#include <QString>

#include <span>

class QPainter;

namespace angiopose::ui {

/// One curve of a plot over the run: its caption with a sample of its line above, decades behind it.
struct LogLane {
    QString caption;
    QString unit;
    QPen pen;
    std::span<const int> positions;   ///< ascending, across
    std::span<const double> values;   ///< 0 lies on the floor: a logarithm has none
};

/// The decades a lane spans, as powers of ten; at least one, so that what does not change looks so.
struct LogSpan {
    double bottom = 0.0, top = 1.0;
};
LogSpan spanOf(std::span<const double> values);

void paintLane(QPainter& painter, const QRectF& area, const LogLane& lane);

}   // namespace angiopose::ui