#include "io/support/file_limits.h"

#include <csignal>

namespace angiopose::io {

void reportFileSizeLimit()
{
    std::signal(SIGXFSZ, SIG_IGN);
}

}   // namespace angiopose::io
