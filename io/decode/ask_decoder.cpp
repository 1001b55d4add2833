#include "io/decode/ask_decoder.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/system/child_process.h"
#include "io/support/system/own_process.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

namespace angiopose::io {
namespace {

constexpr int askedEveryMs = 30;   // interval between checks for cancellation
constexpr std::uintmax_t usualReply = 1 << 20, repliedPerByte = 64;   // bytes
constexpr double decodedShare = 0.9;   // fraction of the progress due to decoding; the rest is the transfer

/// Collects the reply from the pipe. A reply of more than `largestContent` bytes is invalid.
class Listening {
public:
    explicit Listening(std::uintmax_t largestContent) : largestContent_(largestContent) {}

    void hear(std::string_view bytes);
    double fraction() const;   ///< progress of decoding and transfer together
    bool isWhole() const { return heard_.size() >= headSize && heard_.size() == headSize + contentSize(); }
    bool isAstray() const
    {
        return heard_.size() >= headSize &&
               (contentSize() > largestContent_ || heard_.size() > headSize + contentSize());
    }
    DecoderReply reply() && { return {static_cast<ReplyKind>(heard_.front()), std::move(heard_).substr(headSize)}; }

private:
    static constexpr std::size_t headSize = 1 + sizeof(std::uint64_t);

    std::size_t contentSize() const
    {
        std::uint64_t size = 0;
        std::memcpy(&size, heard_.data() + 1, sizeof size);
        return static_cast<std::size_t>(size);
    }

    std::uintmax_t largestContent_;
    double decoded_ = 0.0;
    std::string heard_;   ///< the reply, starting with the byte for its kind
};

void Listening::hear(std::string_view bytes)
{
    while (heard_.empty() && !bytes.empty() && static_cast<unsigned char>(bytes.front()) <= largestPercent) {
        decoded_ = std::max(decoded_, static_cast<unsigned char>(bytes.front()) / double{largestPercent});
        bytes.remove_prefix(1);
    }
    heard_ += bytes;
}

double Listening::fraction() const
{
    if (heard_.size() < headSize) {
        return decodedShare * decoded_;
    }
    const double all = static_cast<double>(headSize) + static_cast<double>(contentSize());
    return decodedShare + (1.0 - decodedShare) * std::min(1.0, static_cast<double>(heard_.size()) / all);
}

enum class Ending { Said, Silent, Astray, Stopped };

Ending listen(const ChildProcess& helper, Listening& listening, const ReadObserver& observe)
{
    std::array<char, 1 << 16> bytes;
    while (!listening.isAstray()) {
        const ChildProcess::Output output = helper.listen(bytes, observe ? askedEveryMs : -1);
        if (isStopRequested(observe, listening.fraction())) {
            return Ending::Stopped;
        }
        if (output.what == ChildProcess::Heard::Bytes) {
            listening.hear({bytes.data(), output.size});
        } else if (output.what == ChildProcess::Heard::End) {
            return listening.isWhole() ? Ending::Said : Ending::Silent;
        }
    }
    return Ending::Astray;
}

}   // namespace

core::Result<DecoderReply> askDecoder(const std::string& program, const std::vector<std::string>& arguments,
                                      const std::string& path, const ReadObserver& observe)
{
    const std::string file = helperProgram(program);
    ChildProcess helper(file, arguments);
    if (!helper.isStarted()) {
        return fileError(path, messages::decoderMissing(file));
    }
    std::error_code isNew;   // set if the file does not exist yet because the helper writes it
    const std::uintmax_t size = std::filesystem::file_size(path, isNew);
    Listening listening(isNew ? usualReply : usualReply + repliedPerByte * size);
    const Ending ending = listen(helper, listening, observe);
    if (ending == Ending::Stopped) {
        return stoppedReading(path);
    }
    if (ending == Ending::Said) {
        DecoderReply reply = std::move(listening).reply();
        return reply.kind == ReplyKind::TooLarge ? fileError(path, messages::decoderTooLarge())
                                                 : core::Result<DecoderReply>(std::move(reply));
    }
    // A helper whose reply is too large is killed as well; that is not a timeout.
    const bool isTooLong = ending == Ending::Silent && helper.waitForEnd() == ChildProcess::Ending::OutOfTime;
    return fileError(path, isTooLong ? messages::decoderTooLong() : messages::decoderDied());
}

std::string helperProgram(const std::string& name)
{
    namespace fs = std::filesystem;
    // The binary is PREFIX/bin/angiopose, PREFIX/lib/libangiopose.so or PREFIX/lib/x86_64-linux-gnu/libangiopose.so.
    const fs::path folder = ownBinary().parent_path();
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
