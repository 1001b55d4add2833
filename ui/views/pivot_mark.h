#pragma once

#include "ui/theme/theme.h"

#include <QPointF>

class QPainter;

namespace angiopose::ui {

/// Draws ring, dot and label at the picked pivot, the same in every view; legible on vessels and on panels.
void paintPivotMark(QPainter& painter, const QPointF& at, const Palette& colors);

}   // namespace angiopose::ui
