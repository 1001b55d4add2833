#pragma once

#include "app/cli/description/command_words.h"

namespace angiopose::app {

/// The page of section 1, as `man` wants it.
std::string manPageOf(const ProgramWords& program);

}   // namespace angiopose::app
