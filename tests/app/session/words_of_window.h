#pragma once

#include <QStringList>

class QWidget;

namespace angiopose::test {

/// All texts of a window and its parts, including tooltips, accessible names, menus and choices, in the order of
/// creation. Omits the state of the session: notes of the strip and times of saving.
QStringList wordsOf(const QWidget& window);

}   // namespace angiopose::test
