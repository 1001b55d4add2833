#pragma once

namespace angiopose::app {

/// Makes buttons and hints name the keys that the user chose. What is said already has to be said again.
void applyChosenKeys();

}   // namespace angiopose::app