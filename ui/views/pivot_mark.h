#pragma once

#include "ui/theme/theme.h"

#include <QPointF>

class QPainter;

namespace angiopose::ui {

/// Ring, dot and word where the picked pivot is, the same in every view; legible on vessels and on panels.
void paintPivotMark(QPainter& painter, const QPointF& at, const Palette& tones);

}   // namespace angiopose::ui