#pragma once

#include "ui/theme/theme.h"

#include <QApplication>
#include <QColor>

namespace angiopose::ui {

/// The theme in use; widgets that paint themselves ask here on every paint.
ThemeMode activeTheme();
const Palette& activePalette();

/// Dresses the whole application: style, style sheet, palette and font. Open windows follow at once.
void applyTheme(QApplication& application, ThemeMode mode);

/// What the desktop prefers, judged by the palette the application started with; ask before `applyTheme`.
ThemeMode systemTheme(const QApplication& application);

QColor toQColor(const Color& color);
QColor toQColor(const Color& color, double opacity);

}   // namespace angiopose::ui