#pragma once

#include <string>
#include <string_view>

namespace angiopose::app {

/// What a terminal shows and does not obey: every control character but line ends and tabs becomes "?". Names in files
/// and answers of archives may hold such commands.
std::string printableText(std::string_view text);

}   // namespace angiopose::app
