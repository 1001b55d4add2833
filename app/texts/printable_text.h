#pragma once

#include <string>
#include <string_view>

namespace angiopose::app {

/// Makes text safe for a terminal by replacing every control character except line ends and tabs with "?". File names
/// and responses of archives may contain control sequences.
std::string printableText(std::string_view text);

}   // namespace angiopose::app
