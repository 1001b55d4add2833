#pragma once

#include <QStringList>

class QWidget;

namespace test {

/// All that a window and its parts say, with tool tips, names for screen readers, menus and choices, in the order in
/// which they were made. Without what says how the session goes: notes of the strip, times of saving.
QStringList wordsOf(const QWidget& window);

}   // namespace test
