#pragma once

#include <QApplication>

namespace angiopose::app {

/// Dresses the application as the user chose. Called before the first window is made, and again after a new choice.
void applyChosenTheme(QApplication& application);

}   // namespace angiopose::app