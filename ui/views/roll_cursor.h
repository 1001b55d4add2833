#pragma once

#include <QCursor>

namespace ui {

/// Curved double arrow: dragging here rolls.
QCursor rollCursor();

}   // namespace ui
