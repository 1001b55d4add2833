#pragma once

namespace app {

/// Makes the program speak as the user chose. Called before the first window is made.
void applyChosenLanguage();

}   // namespace app
