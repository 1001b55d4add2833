#pragma once

#include "app/cli/description/command_words.h"

namespace angiopose::app {

/// What shells complete a command line by: commands, options, their values and files.
std::string bashCompletionOf(const ProgramWords& program);
std::string zshCompletionOf(const ProgramWords& program);
std::string fishCompletionOf(const ProgramWords& program);

}   // namespace angiopose::app
