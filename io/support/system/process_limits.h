#pragma once

#include <cstdint>

namespace angiopose::io {

struct ProcessLimits {
    std::uint64_t processorSeconds = 0;
    std::uint64_t seconds = 0;   ///< of one that only waits
    std::uint64_t furtherMemory =
        0;   ///< bytes beyond what is in use; not under sanitizers, whose shadow takes terabytes
};

/// From now on this process dies when it takes more than that, leaves no core file and writes no file.
void limitOwnProcess(const ProcessLimits& limits);

}   // namespace angiopose::io
