#pragma once

#include "ui/theme/theme.h"

#include <QColor>
#include <QFont>
#include <QPainter>

namespace angiopose::ui {

inline constexpr double annotationMarginPx = 12.0;   ///< between the edges of the picture and what is written on it

/// The tones of what lies on the picture: the dark ones in every theme, as the angiogram lies on black.
const Palette& annotationTones();

QColor colorOf(const Color& color, double opacity = 1.0);

QFont sized(QFont font, int px);

/// Text that stays readable on bright and dark ground; `flags` as QPainter::drawText takes them. `rim`: around it.
void drawShadowedText(QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& color,
                      const Color& rim = annotationTones().canvas);

}   // namespace angiopose::ui
