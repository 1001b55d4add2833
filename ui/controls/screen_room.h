#pragma once

#include <QWidget>

namespace angiopose::ui {

/// Fits a window, saved on a larger screen or at a smaller scale, completely into `room`. At 200 % a screen has half as
/// many points as at 100 %.
void fitInto(const QRect& room, QWidget& window);

/// Resizes to `wanted`, limited to the screen size minus the window frame.
void resizeOnScreen(QWidget& window, const QSize& wanted);

}   // namespace angiopose::ui
