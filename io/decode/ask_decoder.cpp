#include "io/decode/ask_decoder.h"

#include "io/decode/helper_program.h"
#include "io/messages/says.h"
#include "io/support/file_error.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

namespace angiopose::io {
namespace {

constexpr int askedEveryMs = 30;   // whether to stop
constexpr std::uintmax_t usualReply = 1 << 20, repliedPerByte = 64;   // bytes
constexpr double decodedShare = 0.9;   // of the progress; the rest is sending

/// A running program and the end of the pipe that it writes to. Killed, if it still runs, with the object.
class Helper {
public:
    Helper(const std::string& program, std::vector<std::string> arguments);
    Helper(const Helper&) = delete;
    Helper& operator=(const Helper&) = delete;
    ~Helper()
    {
        if (output_ >= 0) {
            ::close(output_);
        }
        if (id_ > 0) {
            ::kill(id_, SIGKILL);
            waitForEnd();
        }
    }

    bool isStarted() const { return id_ > 0; }
    int output() const { return output_; }
    int waitForEnd();   ///< what ended it: a signal, or 0

private:
    pid_t id_ = -1;
    int output_ = -1;
};

Helper::Helper(const std::string& program, std::vector<std::string> arguments)
{
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        return;
    }
    output_ = ends[0];
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    // A group of its own: Ctrl+C is for the program that asks, which then stops the helper.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (std::string& argument : arguments) {
        words.push_back(argument.data());
    }
    words.push_back(nullptr);
    if (::posix_spawn(&id_, program.c_str(), &files, &attributes, words.data(), environ) != 0) {
        id_ = -1;
    }
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
}

int Helper::waitForEnd()
{
    int status = 0;
    pid_t ended = 0;
    do {
        ended = ::waitpid(id_, &status, 0);
    } while (ended < 0 && errno == EINTR);
    id_ = -1;
    return ended > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

/// What comes out of the pipe, bit by bit. More than `largestContent` bytes are none of a decoder.
class Listening {
public:
    explicit Listening(std::uintmax_t largestContent) : largestContent_(largestContent) {}

    void hear(std::string_view bytes);
    double fraction() const;   ///< of the whole work
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
    std::string heard_;   ///< from the byte on that says what follows
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

Ending listen(const Helper& helper, Listening& listening, const ReadObserver& observe)
{
    std::array<char, 1 << 16> bytes;
    while (!listening.isAstray()) {
        pollfd ready{helper.output(), POLLIN, 0};
        const int events = ::poll(&ready, 1, observe ? askedEveryMs : -1);
        if (isStopWished(observe, listening.fraction())) {
            return Ending::Stopped;
        }
        if (events <= 0) {
            continue;   // nothing yet, or a signal came
        }
        const ssize_t count = ::read(helper.output(), bytes.data(), bytes.size());
        if (count > 0) {
            listening.hear({bytes.data(), static_cast<std::size_t>(count)});
        } else if (count == 0 || errno != EINTR) {
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
    Helper helper(file, arguments);
    if (!helper.isStarted()) {
        return fileError(path, says::decoderMissing(file));
    }
    std::error_code isNew;   // a file that is to be written
    const std::uintmax_t size = std::filesystem::file_size(path, isNew);
    Listening listening(isNew ? usualReply : usualReply + repliedPerByte * size);
    const Ending ending = listen(helper, listening, observe);
    if (ending == Ending::Stopped) {
        return stoppedReading(path);
    }
    if (ending == Ending::Said) {
        DecoderReply reply = std::move(listening).reply();
        return reply.kind == ReplyKind::TooLarge ? fileError(path, says::decoderTooLarge())
                                                 : core::Result<DecoderReply>(std::move(reply));
    }
    const int signal = ending == Ending::Silent ? helper.waitForEnd() : 0;   // who talks on is killed
    const bool isTooLong = signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL;
    return fileError(path, isTooLong ? says::decoderTooLong() : says::decoderDied());
}

}   // namespace angiopose::io
