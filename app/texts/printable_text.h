#pragma once

#include <string>
#include <string_view>

namespace angiopose::app {

/// Makes text safe for a terminal: every control character except line ends and tabs becomes "?". Names in files and
/// responses of archives may contain control sequences.
std::string printableText(std::string_view text);

}   // namespace angiopose::app
