#pragma once

#include "ui/theme/theme.h"

#include <QLineF>
#include <QPointF>

class QPainter;

namespace angiopose::ui {

/// Paints four short strokes around the linked position, the same in images and 3-D; legible on vessels and on panels.
void paintCrosshairMark(QPainter& painter, const QPointF& at, const Palette& colors);

/// Paints the epipolar line of a pointer position in another image, thin enough to keep vessels visible.
void paintEpipolarLine(QPainter& painter, const QLineF& line, const Palette& colors);

}   // namespace angiopose::ui
