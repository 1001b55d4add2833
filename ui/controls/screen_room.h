#pragma once

#include <QWidget>

namespace angiopose::ui {

/// A window that was left on a larger screen, or at a smaller scale, is whole on `room`. At 200 % a screen has half as
/// many points as at 100 %.
void fitInto(const QRect& room, QWidget& window);

/// `wanted`, or what its screen has room for beside the frame of a window.
void resizeOnScreen(QWidget& window, const QSize& wanted);

}   // namespace angiopose::ui
