#pragma once

#include <QCursor>

namespace angiopose::ui {

/// Curved double arrow: dragging here rolls.
QCursor rollCursor();

}   // namespace angiopose::ui