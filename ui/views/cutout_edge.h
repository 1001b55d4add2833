#pragma once

#include "ui/scenes/cutout.h"
#include "ui/views/image_viewport.h"

#include <QPainterPath>
#include <QSizeF>

class QPainter;

namespace angiopose::ui {

/// What the cutout keeps bare of a widget of this size, in widget px; empty without a cutout.
QPainterPath cutoutPath(const Cutout& cutout, const ImageViewport& viewport, const QSizeF& size);

/// The swipe's line or the lens's ring, so that the eye sees where the overlay ends.
void paintCutoutEdge(QPainter& painter, const QPainterPath& path);

}   // namespace angiopose::ui