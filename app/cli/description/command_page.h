#pragma once

#include "app/cli/description/command_words.h"

#include <string>

namespace angiopose::app {

/// The commands as a page of the manual, in Markdown.
std::string commandPageOf(const ProgramWords& program);

}   // namespace angiopose::app
