#include "io/support/system/run_program.h"

#include "io/support/system/spawn_attributes.h"

#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>

namespace angiopose::io {
namespace {

constexpr useconds_t askedEveryUs = 20000;

/// Starts a program with this process's streams and returns its process ID; negative on failure.
pid_t startWithOurStreams(const std::string& program, std::vector<std::string> arguments)
{
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
    const SpawnAttributes attributes;
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (std::string& argument : arguments) {
        words.push_back(argument.data());
    }
    words.push_back(nullptr);
    pid_t id = -1;
    if (::posix_spawnp(&id, program.c_str(), &files, attributes.get(), words.data(), environ) != 0) {
        id = -1;
    }
    ::posix_spawn_file_actions_destroy(&files);
    return id;
}

}   // namespace

ProgramExit runProgram(const std::string& program, std::vector<std::string> arguments, bool (*isStopped)())
{
    const pid_t id = startWithOurStreams(program, std::move(arguments));
    if (id < 0) {
        return {};
    }
    int status = 0;
    bool isKnown = false;
    for (pid_t ended = 0; ended != id; ended = ::waitpid(id, &status, WNOHANG)) {
        if (ended < 0 && errno != EINTR) {
            return {};
        }
        if (isStopped() && !isKnown) {
            ::kill(id, SIGTERM);
            isKnown = true;
        }
        ::usleep(askedEveryUs);
    }
    return WIFSIGNALED(status) ? ProgramExit{true, 0, WTERMSIG(status)} : ProgramExit{true, WEXITSTATUS(status), 0};
}

}   // namespace angiopose::io
