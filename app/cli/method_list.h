#pragma once

#include <string>

namespace angiopose::app {

/// Lists every method id with its summary, for the help texts of commands.
std::string methodList();

}   // namespace angiopose::app
