#pragma once

#include <string>

namespace angiopose::app {

/// For the help of commands: every method id with its summary.
std::string methodList();

}   // namespace angiopose::app