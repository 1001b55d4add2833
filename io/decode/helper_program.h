#pragma once

#include <string>

namespace angiopose::io {

/// Path of a program that AngioPose brings along: below the folder that holds the running program, or the library that
/// this code is part of, or where it was to be installed. It may be missing there.
std::string helperProgram(const std::string& name);

}   // namespace angiopose::io
