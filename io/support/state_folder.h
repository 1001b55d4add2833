#pragma once

#include <filesystem>

namespace angiopose::io {

/// Where this user's programs keep what outlives a session and is no document: `$XDG_STATE_HOME/angiopose`, or below
/// `~/.local/state`. It need not be there.
std::filesystem::path stateFolder();

/// Where dumps of faults lie, one for window and command line.
std::filesystem::path crashFolder();

}   // namespace angiopose::io
