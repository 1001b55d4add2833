#include "app/decode/helper_session.h"

#include "io/support/system/process_limits.h"

#include <algorithm>
#include <cstdio>
#include <new>

namespace angiopose::decode {
namespace {

using io::DecoderReply;
using io::ReplyKind;

/// Writes bytes to stdout; returns false if the reading process has ended.
bool write(const char* bytes, std::size_t size)
{
    return std::fwrite(bytes, 1, size, stdout) == size && std::fflush(stdout) == 0;
}

DecoderReply replyOf(const std::function<DecoderReply()>& work)
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return {ReplyKind::TooLarge, {}};
    } catch (...) {   // the libraries may throw exceptions of any type
        return {ReplyKind::Refusal, {}};
    }
}

}   // namespace

void limitProcess(std::size_t fileSize)
{
    constexpr std::uint64_t spareSeconds = 5, bytesPerSecond = 2'000'000;
    constexpr std::uint64_t spareMemory = std::uint64_t{256} << 20, memoryPerByte = 64;
    const std::uint64_t seconds = spareSeconds + fileSize / bytesPerSecond;
    io::limitCurrentProcess(
        {seconds, std::min<std::uint64_t>(20 * seconds, 86'400), spareMemory + memoryPerByte * fileSize});
}

void writeProgress(double fraction)
{
    static int lastPercent = 0;
    const int percent = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * io::maxPercent);
    if (percent > lastPercent) {
        lastPercent = percent;
        const char byte = static_cast<char>(percent);
        write(&byte, 1);
    }
}

int writeReply(const std::function<DecoderReply()>& work)
{
    const DecoderReply reply = replyOf(work);
    io::ReplyWriter head;
    head.put(static_cast<unsigned char>(reply.kind));
    head.put(std::uint64_t{reply.content.size()});
    const std::string bytes = std::move(head).bytes();
    return write(bytes.data(), bytes.size()) && write(reply.content.data(), reply.content.size()) ? 0 : 1;
}

}   // namespace angiopose::decode
