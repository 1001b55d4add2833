#pragma once

#include "ui/theme/theme.h"

#include <QLineF>
#include <QPointF>

class QPainter;

namespace angiopose::ui {

/// Four short strokes around the place that all views mean, the same in images and 3-D; legible on vessels and panels.
void paintPlaceMark(QPainter& painter, const QPointF& at, const Palette& tones);

/// The line on which the place under the pointer of another image lies; thin, so that vessels show through.
void paintEpipolarLine(QPainter& painter, const QLineF& line, const Palette& tones);

}   // namespace angiopose::ui
