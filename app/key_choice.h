#pragma once

namespace app {

/// Makes buttons and hints name the keys that the user chose. Called before a window is made.
void applyChosenKeys();

}   // namespace app
