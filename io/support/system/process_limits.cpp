#include "io/support/system/process_limits.h"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>
#include <cstdio>

namespace angiopose::io {
namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Returns the size of the address space in use, including libraries, bytes.
rlim_t addressSpaceNow()
{
    unsigned long pages = 1 << 18;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%lu", &pages) != 1) {
            pages = 1 << 18;
        }
        std::fclose(file);
    }
    return static_cast<rlim_t>(pages) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}
#endif

void limitResource(decltype(RLIMIT_CORE) what, rlim_t most)
{
    const rlimit both{most, most};
    ::setrlimit(what, &both);
}

}   // namespace

void limitCurrentProcess(const ProcessLimits& limits)
{
    limitResource(RLIMIT_CORE, 0);
    limitResource(RLIMIT_FSIZE, 0);
    limitResource(RLIMIT_CPU, limits.cpuSeconds);
    ::alarm(static_cast<unsigned int>(limits.seconds));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    ::mallopt(M_ARENA_MAX, 1);   // every additional arena takes 64 MB of address space
    limitResource(RLIMIT_AS, addressSpaceNow() + limits.additionalMemoryBytes);
#endif
}

}   // namespace angiopose::io
