#include "tests/benchmark/stack_watch.h"

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <memory>

namespace angiopose::benchmarks {
namespace {

constexpr int deepest = 96;
std::array<void*, deepest> frames;   // written by the signal handler on the watched thread, read by the same thread
volatile std::sig_atomic_t frameCount = 0;

void noteStack(int /*signal*/)
{
    frameCount = backtrace(frames.data(), deepest);
}

/// The function's name without its parameters; empty if it has no name.
std::string nameOf(const char* mangled)
{
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> readable(abi::__cxa_demangle(mangled, nullptr, nullptr, &status),
                                                               &std::free);
    const std::string name = status == 0 ? readable.get() : mangled;
    return name.substr(0, name.find('('));
}

}   // namespace

StackWatch::StackWatch(double afterMs) : afterMs_(afterMs)
{
    backtrace(frames.data(), 1);   // loads the required libraries now, not in the signal handler
    struct sigaction action {};
    action.sa_handler = noteStack;
    action.sa_flags = SA_RESTART;
    sigaction(SIGPROF, &action, nullptr);
    sigevent event{};
    event.sigev_notify = SIGEV_THREAD_ID;
    event.sigev_signo = SIGPROF;
    event._sigev_un._tid = gettid();
    timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &timer_);
}

StackWatch::~StackWatch()
{
    timer_delete(timer_);
}

void StackWatch::arm(double ms) const
{
    itimerspec when{};
    when.it_value.tv_nsec = static_cast<long>(1e6 * ms);
    timer_settime(timer_, 0, &when, nullptr);
}

void StackWatch::begin() const
{
    frameCount = 0;
    arm(afterMs_);
}

std::vector<std::string> StackWatch::end() const
{
    arm(0.0);
    std::vector<std::string> names;
    for (int i = 0; i < frameCount; ++i) {
        Dl_info info{};
        if (dladdr(frames[static_cast<std::size_t>(i)], &info) != 0 && info.dli_sname) {
            names.push_back(nameOf(info.dli_sname));
        }
    }
    return names;
}

}   // namespace angiopose::benchmarks
