#include "io/support/system/worker_process.h"

#include "io/support/system/spawn_attributes.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace angiopose::io {
namespace {

constexpr int channelNumber = 3;   // file descriptor of the channel in the worker

/// Returns the worker's environment: that of this process, in which `added` replaces variables of the same name.
std::vector<std::string> environmentWith(const std::vector<std::string>& added)
{
    std::vector<std::string> all = added;
    const auto nameOf = [](const std::string& pair) { return pair.substr(0, pair.find('=') + 1); };
    for (char** own = environ; *own != nullptr; ++own) {
        const std::string pair = *own;
        const auto isSame = [&](const std::string& each) { return nameOf(each) == nameOf(pair); };
        if (std::none_of(added.begin(), added.end(), isSame)) {
            all.push_back(pair);
        }
    }
    return all;
}

std::vector<char*> pointersTo(std::vector<std::string>& words)
{
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

bool sendAll(int channel, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t sent = ::send(channel, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) {
            continue;
        }
        if (sent <= 0) {
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

/// Moves the first line of `heard` to `line`; returns false if there is no complete line.
bool takeLine(std::string& heard, std::string& line)
{
    const std::size_t end = heard.find('\n');
    if (end == std::string::npos) {
        return false;
    }
    line = heard.substr(0, end);
    heard.erase(0, end + 1);
    return true;
}

}   // namespace

WorkerProcess::WorkerProcess(const std::string& program, std::vector<std::string> arguments,
                             const std::vector<std::string>& environment)
{
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return;
    }
    channel_ = ends[0];
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    // First duplicate to a high number, because dup2 of 3 onto itself would keep the close-on-exec flag.
    const int high = ::fcntl(ends[1], F_DUPFD_CLOEXEC, channelNumber + 1);
    ::posix_spawn_file_actions_adddup2(&files, high, channelNumber);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&files, channelNumber + 1);
    const SpawnAttributes attributes;
    arguments.insert(arguments.begin(), program);
    std::vector<std::string> pairs = environmentWith(environment);
    if (::posix_spawn(&id_, program.c_str(), &files, attributes.get(), pointersTo(arguments).data(),
                      pointersTo(pairs).data()) != 0) {
        id_ = -1;
    }
    ::posix_spawn_file_actions_destroy(&files);
    ::close(high);
    ::close(ends[1]);
}

WorkerProcess::~WorkerProcess()
{
    end();
    if (channel_ >= 0) {
        ::close(channel_);
    }
}

bool WorkerProcess::sendLine(const std::string& line) const
{
    return sendAll(channel_, line + "\n");
}

WorkerProcess::ReadStatus WorkerProcess::receiveLine(std::string& line)
{
    std::array<char, 1 << 16> bytes;
    while (!takeLine(partialLine_, line)) {
        const ssize_t count = ::recv(channel_, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
            return ReadStatus::Nothing;
        }
        if (count <= 0) {
            return ReadStatus::End;
        }
        partialLine_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return ReadStatus::Line;
}

void WorkerProcess::requestStop() const
{
    if (id_ > 0) {
        ::kill(id_, SIGTERM);
    }
}

std::string WorkerProcess::end()
{
    if (id_ <= 0) {
        return {};
    }
    int status = 0;
    pid_t ended = ::waitpid(id_, &status, WNOHANG);
    // A worker that has closed the channel is about to end on its own, so wait to report how it ended.
    for (int waited = 0; ended == 0 && waited < 200; ++waited) {
        pollfd channel{channel_, POLLIN, 0};
        if (::poll(&channel, 1, 0) <= 0 || (channel.revents & POLLHUP) == 0) {
            break;
        }
        ::usleep(5000);
        ended = ::waitpid(id_, &status, WNOHANG);
    }
    const bool wasOver = ended == id_;
    if (!wasOver) {
        ::kill(id_, SIGKILL);
        while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
        }
    }
    id_ = -1;
    if (!wasOver) {
        return {};
    }
    return WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                               : "exit code " + std::to_string(WEXITSTATUS(status));
}

void WorkerProcess::waitForAny(std::span<const WorkerProcess* const> workers, int milliseconds)
{
    std::vector<pollfd> channels;
    for (const WorkerProcess* worker : workers) {
        channels.push_back({worker->channel_, POLLIN, 0});
    }
    ::poll(channels.data(), channels.size(), milliseconds);
}

bool WorkerChannel::open(int parent)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    int type = 0;
    socklen_t size = sizeof type;
    return ::getppid() == parent && ::getsockopt(channelNumber, SOL_SOCKET, SO_TYPE, &type, &size) == 0;
}

bool WorkerChannel::receiveLine(std::string& line, bool (*isStopped)())
{
    static std::string heard;
    std::array<char, 1 << 12> bytes;
    while (!takeLine(heard, line)) {
        pollfd channel{channelNumber, POLLIN, 0};
        constexpr int pollIntervalMs = 200;
        const int ready = isStopped() ? -1 : ::poll(&channel, 1, pollIntervalMs);
        if (isStopped()) {
            return false;
        }
        if (ready <= 0) {
            continue;
        }
        const ssize_t count = ::recv(channelNumber, bytes.data(), bytes.size(), 0);
        if (count <= 0) {
            return false;
        }
        heard.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return true;
}

bool WorkerChannel::sendLine(const std::string& line)
{
    return sendAll(channelNumber, line + "\n");
}

}   // namespace angiopose::io
