#include "app/decode/helper_session.h"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <new>

namespace angiopose::decode {
namespace {

using io::DecoderReply;
using io::ReplyKind;

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)   // their shadow takes terabytes
constexpr rlim_t spareMemory = rlim_t{256} << 20;
constexpr rlim_t memoryPerByte = 64;

/// Libraries included.
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

void limit(decltype(RLIMIT_CORE) what, rlim_t most)
{
    const rlimit both{most, most};
    ::setrlimit(what, &both);
}

/// False when nobody listens any more.
bool write(const char* bytes, std::size_t size)
{
    while (size > 0) {
        const ssize_t written = ::write(STDOUT_FILENO, bytes, size);
        if (written <= 0) {
            return false;
        }
        bytes += written;
        size -= static_cast<std::size_t>(written);
    }
    return true;
}

DecoderReply replyOf(const std::function<DecoderReply()>& work)
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return {ReplyKind::TooLarge, {}};
    } catch (...) {   // libraries throw all kinds of things
        return {ReplyKind::Refusal, {}};
    }
}

}   // namespace

void limitProcess(std::size_t fileSize)
{
    constexpr rlim_t spareSeconds = 5, bytesPerSecond = 2'000'000;
    const rlim_t seconds = spareSeconds + fileSize / bytesPerSecond;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, seconds);
    ::alarm(static_cast<unsigned int>(std::min<rlim_t>(20 * seconds, 86'400)));   // one that only waits
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    ::mallopt(M_ARENA_MAX, 1);   // every further one takes 64 MB of address space
    limit(RLIMIT_AS, addressSpaceNow() + spareMemory + memoryPerByte * fileSize);
#endif
}

void sayProgress(double fraction)
{
    static int said = 0;
    const int percent = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * io::largestPercent);
    if (percent > said) {
        said = percent;
        const char byte = static_cast<char>(percent);
        write(&byte, 1);
    }
}

int sayReply(const std::function<DecoderReply()>& work)
{
    const DecoderReply reply = replyOf(work);
    io::ReplyWriter head;
    head.put(static_cast<unsigned char>(reply.kind));
    head.put(std::uint64_t{reply.content.size()});
    const std::string bytes = std::move(head).bytes();
    return write(bytes.data(), bytes.size()) && write(reply.content.data(), reply.content.size()) ? 0 : 1;
}

}   // namespace angiopose::decode
