#pragma once

namespace angiopose::app {

/// Makes the program speak as the user chose. Before the first window is made; later, what is said already has to be
/// said again.
void applyChosenLanguage();

}   // namespace angiopose::app