#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// The same text, ended by a zero and there until the program ends: for names that the program itself has as literals.
/// Called from any thread.
std::string_view lasting(const std::string& text);

}   // namespace angiopose::io
