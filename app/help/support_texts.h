#pragma once

#include "io/sharing/known_words.h"

#include <string>

namespace angiopose::app {

/// Toolkit, screens and who draws, as "key: value" in lines. On the window's thread.
std::string windowFacts();

/// Preferences that are switches, numbers or one of a few names; of texts only whether there is one.
std::string settingsText();

/// Every word of the catalogues, in English and as the window speaks, and of the menus.
io::KnownWords wordsOfProgram();

}   // namespace angiopose::app
