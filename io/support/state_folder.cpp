#include "io/support/state_folder.h"

#include <cstdlib>

namespace angiopose::io {

namespace fs = std::filesystem;

fs::path stateFolder()
{
    const char* state = std::getenv("XDG_STATE_HOME");
    const char* home = std::getenv("HOME");
    const fs::path base =
        state != nullptr && *state == '/' ? fs::path(state) : fs::path(home != nullptr ? home : ".") / ".local/state";
    return base / "angiopose";
}

fs::path crashFolder()
{
    return stateFolder() / "crashes";
}

}   // namespace angiopose::io
