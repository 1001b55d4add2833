#pragma once

#include <cstdint>

namespace angiopose::io {

struct ProcessLimits {
    std::uint64_t processorSeconds = 0;
    std::uint64_t seconds = 0;   ///< wall-clock limit, which also ends a process that only waits
    std::uint64_t furtherMemory =
        0;   ///< bytes beyond those in use; not under sanitizers, whose shadow memory takes terabytes
};

/// Makes this process end when it exceeds these limits, leave no core file and write no file.
void limitOwnProcess(const ProcessLimits& limits);

}   // namespace angiopose::io
