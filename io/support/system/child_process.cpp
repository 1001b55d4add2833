#include "io/support/system/child_process.h"

#include "io/support/system/spawn_attributes.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>

namespace angiopose::io {

ChildProcess::ChildProcess(const std::string& program, std::vector<std::string> arguments)
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
    const SpawnAttributes attributes;
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (std::string& argument : arguments) {
        words.push_back(argument.data());
    }
    words.push_back(nullptr);
    if (::posix_spawn(&id_, program.c_str(), &files, attributes.get(), words.data(), environ) != 0) {
        id_ = -1;
    }
    ::posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
}

ChildProcess::~ChildProcess()
{
    if (output_ >= 0) {
        ::close(output_);
    }
    if (id_ > 0) {
        ::kill(id_, SIGKILL);
        waitForExit();
    }
}

ChildProcess::Output ChildProcess::readOutput(std::span<char> buffer, int milliseconds) const
{
    pollfd ready{output_, POLLIN, 0};
    if (::poll(&ready, 1, milliseconds) <= 0) {
        return {};
    }
    const ssize_t count = ::read(output_, buffer.data(), buffer.size());
    if (count > 0) {
        return {ReadStatus::Bytes, static_cast<std::size_t>(count)};
    }
    return {count == 0 || errno != EINTR ? ReadStatus::End : ReadStatus::Nothing, 0};
}

ChildProcess::EndReason ChildProcess::waitForExit()
{
    int status = 0;
    pid_t ended = 0;
    do {
        ended = ::waitpid(id_, &status, 0);
    } while (ended < 0 && errno == EINTR);
    id_ = -1;
    if (ended <= 0 || !WIFSIGNALED(status)) {
        return EndReason::Normal;
    }
    const int signal = WTERMSIG(status);
    return signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL ? EndReason::TimedOut : EndReason::Fault;
}

}   // namespace angiopose::io
