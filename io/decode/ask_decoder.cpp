#include "io/decode/ask_decoder.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/system/child_process.h"
#include "io/support/system/current_process.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

namespace angiopose::io {
namespace {

constexpr int pollIntervalMs = 30;   // interval between checks for cancellation
constexpr std::uintmax_t baseReplyBytes = 1 << 20, replyBytesPerByte = 64;   // reply size limit, bytes
constexpr double decodedShare = 0.9;   // fraction of the progress due to decoding; the rest is the transfer

/// Collects the reply from the pipe. A reply of more than `largestContent` bytes is invalid.
class ReplyReceiver {
public:
    explicit ReplyReceiver(std::uintmax_t largestContent) : largestContent_(largestContent) {}

    void appendReply(std::string_view bytes);
    double fraction() const;   ///< progress of decoding and transfer together
    bool isComplete() const { return reply_.size() >= headSize && reply_.size() == headSize + contentSize(); }
    bool isInvalid() const
    {
        return reply_.size() >= headSize &&
               (contentSize() > largestContent_ || reply_.size() > headSize + contentSize());
    }
    DecoderReply reply() && { return {static_cast<ReplyKind>(reply_.front()), std::move(reply_).substr(headSize)}; }

private:
    static constexpr std::size_t headSize = 1 + sizeof(std::uint64_t);

    std::size_t contentSize() const
    {
        std::uint64_t size = 0;
        std::memcpy(&size, reply_.data() + 1, sizeof size);
        return static_cast<std::size_t>(size);
    }

    std::uintmax_t largestContent_;
    double decoded_ = 0.0;
    std::string reply_;   ///< the reply, starting with the byte that states its kind
};

void ReplyReceiver::appendReply(std::string_view bytes)
{
    while (reply_.empty() && !bytes.empty() && static_cast<unsigned char>(bytes.front()) <= maxPercent) {
        decoded_ = std::max(decoded_, static_cast<unsigned char>(bytes.front()) / double{maxPercent});
        bytes.remove_prefix(1);
    }
    reply_ += bytes;
}

double ReplyReceiver::fraction() const
{
    if (reply_.size() < headSize) {
        return decodedShare * decoded_;
    }
    const double all = static_cast<double>(headSize) + static_cast<double>(contentSize());
    return decodedShare + (1.0 - decodedShare) * std::min(1.0, static_cast<double>(reply_.size()) / all);
}

enum class EndReason { Complete, NoReply, InvalidReply, Stopped };

EndReason readOutput(const ChildProcess& helper, ReplyReceiver& replyReceiver, const ReadObserver& observe)
{
    std::array<char, 1 << 16> bytes;
    while (!replyReceiver.isInvalid()) {
        const ChildProcess::Output output = helper.readOutput(bytes, observe ? pollIntervalMs : -1);
        if (isStopRequested(observe, replyReceiver.fraction())) {
            return EndReason::Stopped;
        }
        if (output.what == ChildProcess::ReadStatus::Bytes) {
            replyReceiver.appendReply({bytes.data(), output.size});
        } else if (output.what == ChildProcess::ReadStatus::End) {
            return replyReceiver.isComplete() ? EndReason::Complete : EndReason::NoReply;
        }
    }
    return EndReason::InvalidReply;
}

}   // namespace

core::Result<DecoderReply> runDecoder(const std::string& program, const std::vector<std::string>& arguments,
                                      const std::string& path, const ReadObserver& observe)
{
    const std::string file = helperPath(program);
    ChildProcess helper(file, arguments);
    if (!helper.isStarted()) {
        return fileError(path, messages::decoderMissing(file));
    }
    std::error_code isNew;   // set if the file does not exist yet because the helper writes it
    const std::uintmax_t size = std::filesystem::file_size(path, isNew);
    ReplyReceiver replyReceiver(isNew ? baseReplyBytes : baseReplyBytes + replyBytesPerByte * size);
    const EndReason ending = readOutput(helper, replyReceiver, observe);
    if (ending == EndReason::Stopped) {
        return readingCanceled(path);
    }
    if (ending == EndReason::Complete) {
        DecoderReply reply = std::move(replyReceiver).reply();
        return reply.kind == ReplyKind::TooLarge ? fileError(path, messages::decoderTooLarge())
                                                 : core::Result<DecoderReply>(std::move(reply));
    }
    // A helper whose reply is too large is also killed, but that is not a timeout.
    const bool isTooLong = ending == EndReason::NoReply && helper.waitForExit() == ChildProcess::EndReason::TimedOut;
    return fileError(path, isTooLong ? messages::decoderTooLong() : messages::decoderDied());
}

std::string helperPath(const std::string& name)
{
    namespace fs = std::filesystem;
    // The binary is PREFIX/bin/angiopose, PREFIX/lib/libangiopose.so or PREFIX/lib/x86_64-linux-gnu/libangiopose.so.
    const fs::path folder = currentBinaryPath().parent_path();
    for (const fs::path& prefix : {folder.parent_path(), folder.parent_path().parent_path()}) {
        const fs::path candidate = prefix / ANGIOPOSE_HELPER_FOLDER / name;
        if (!prefix.empty() && isExecutable(candidate)) {
            return candidate;
        }
    }
    // A library-only package installs the helpers next to the library.
    const fs::path beside = folder / "angiopose" / name;
    return isExecutable(beside) ? beside : fs::path(ANGIOPOSE_INSTALLED_HELPERS) / name;
}

}   // namespace angiopose::io
