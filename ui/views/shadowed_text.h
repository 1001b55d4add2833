#pragma once

#include "ui/theme/theme.h"

#include <QColor>
#include <QFont>
#include <QPainter>

namespace angiopose::ui {

inline constexpr double annotationMarginPx = 12.0;   ///< margin between the edges of the image and text

/// Returns the colors of annotations on the image: those of the dark theme, because the image background is black.
const Palette& annotationTones();

QColor colorOf(const Color& color, double opacity = 1.0);

QFont withPixelSize(QFont font, int px);

/// Draws text that is readable on bright and dark backgrounds; `flags` as in QPainter::drawText, `rim` is the color of
/// the outline.
void drawShadowedText(QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& color,
                      const Color& rim = annotationTones().canvas);

}   // namespace angiopose::ui
