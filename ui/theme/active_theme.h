#pragma once

#include "ui/theme/theme.h"

#include <QApplication>
#include <QColor>

namespace angiopose::ui {

/// Returns the current theme; custom-painted widgets query it on every paint.
ThemeMode activeTheme();
const Palette& activePalette();

/// Applies style, style sheet, palette and font to the whole application, including open windows.
void applyTheme(QApplication& application, ThemeMode mode);

/// Returns the desktop's preference, derived from the application's initial palette; call before `applyTheme`.
ThemeMode systemTheme(const QApplication& application);

QColor toQColor(const Color& color);
QColor toQColor(const Color& color, double opacity);

}   // namespace angiopose::ui
