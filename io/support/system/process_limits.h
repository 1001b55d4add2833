#pragma once

#include <cstdint>

namespace angiopose::io {

struct ProcessLimits {
    std::uint64_t cpuSeconds = 0;
    std::uint64_t seconds = 0;   ///< wall-clock limit, which also applies to a process that is only waiting
    std::uint64_t additionalMemoryBytes =
        0;   ///< limit of additional memory, bytes; not applied under sanitizers, whose shadow memory takes terabytes
};

/// Makes the system terminate this process if it exceeds the limits, and prevents it from writing files and core dumps.
void limitCurrentProcess(const ProcessLimits& limits);

}   // namespace angiopose::io
