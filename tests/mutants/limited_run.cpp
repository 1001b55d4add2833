#include "tests/mutants/limited_run.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <thread>

namespace angiopose::test {
namespace {

[[noreturn]] void become(const std::vector<std::string>& command, const RunLimits& limits, const std::string& output)
{
    const int file = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    if (limits.addressSpaceBytes > 0) {
        const rlimit space{limits.addressSpaceBytes, limits.addressSpaceBytes};
        ::setrlimit(RLIMIT_AS, &space);
    }
    if (limits.seconds > 0) {
        const rlimit time{limits.seconds, limits.seconds + 1};
        ::setrlimit(RLIMIT_CPU, &time);
    }
    std::vector<char*> arguments;
    for (const std::string& argument : command) {
        arguments.push_back(const_cast<char*>(argument.c_str()));
    }
    arguments.push_back(nullptr);
    ::execv(arguments.front(), arguments.data());
    ::_exit(127);
}

double secondsOf(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}   // namespace

LimitedRun runLimited(const std::vector<std::string>& command, const RunLimits& limits, const std::string& output)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const pid_t child = ::fork();
    if (child == 0) {
        become(command, limits, output);
    }
    LimitedRun run;
    int status = 0;
    rusage usage{};
    for (auto pause = std::chrono::milliseconds(1); ::wait4(child, &status, WNOHANG, &usage) == 0;) {
        std::this_thread::sleep_for(pause);
        const std::chrono::duration<double> passed = Clock::now() - start;
        if (limits.seconds > 0 && passed.count() > 10.0 * limits.seconds && !run.isTimedOut) {
            run.isTimedOut = true;
            ::kill(child, SIGKILL);
        }
    }
    run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    run.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    run.isTimedOut |= run.signal == SIGXCPU;
    run.cpuSeconds = secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
    run.peakKilobytes = usage.ru_maxrss;
    return run;
}

}   // namespace angiopose::test
