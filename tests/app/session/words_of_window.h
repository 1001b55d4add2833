#pragma once

#include <QStringList>

class QWidget;

namespace angiopose::test {

/// All that a window and its parts say, with tool tips, names for screen readers, menus and choices, in the order in
/// which they were made. Without what says how the session goes: notes of the strip, times of saving.
QStringList wordsOf(const QWidget& window);

}   // namespace angiopose::test