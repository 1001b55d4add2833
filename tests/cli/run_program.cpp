#include "tests/cli/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace angiopose::test {
namespace {

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

[[noreturn]] void becomeProgram(const std::string& path, const std::vector<std::string>& arguments,
                                const std::string& outputPath, const std::string& messagePath)
{
    const int output = open(outputPath.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int messages = open(messagePath.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(output, STDOUT_FILENO);
    dup2(messages, STDERR_FILENO);
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    std::vector<std::string> words{path};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    execv(path.c_str(), pointers.data());
    _exit(127);
}

}   // namespace

ProgramOutcome runCli(const std::vector<std::string>& arguments, double interruptAfterSeconds)
{
    return runProgram(CLI_PROGRAM, arguments, interruptAfterSeconds);
}

ProgramOutcome runProgram(const std::string& path, const std::vector<std::string>& arguments,
                          double interruptAfterSeconds)
{
    static std::atomic<int> runs{0};   // several tests run at once
    const auto folder = std::filesystem::temp_directory_path();
    const std::string stem =
        (folder / ("angiopose-cli-test-" + std::to_string(getpid()) + "-" + std::to_string(++runs))).string();

    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child == 0) {
        becomeProgram(path, arguments, stem + ".out", stem + ".err");
    }
    if (interruptAfterSeconds > 0.0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(interruptAfterSeconds));
        kill(child, SIGINT);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);

    ProgramOutcome outcome;
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.peakMemoryKiB = usage.ru_maxrss;
    outcome.output = contentOf(stem + ".out");
    outcome.messages = contentOf(stem + ".err");
    std::filesystem::remove(stem + ".out");
    std::filesystem::remove(stem + ".err");
    return outcome;
}

}   // namespace angiopose::test
