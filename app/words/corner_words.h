#pragma once

#include "app/texts/case_texts.h"

namespace angiopose::app {

/// Corner lines in the language of the window, see englishTexts.
ui::CornerTexts windowTexts(const CornerLines& lines);

}   // namespace angiopose::app
