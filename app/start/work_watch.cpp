#include "app/start/work_watch.h"

#include "io/support/system/own_process.h"

#include <atomic>
#include <csignal>
#include <cstdio>

namespace angiopose::app {
namespace {

std::atomic<bool> stopWished{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the signal handler must not lock");
int lastPercent = -1;

extern "C" void onStopSignal(int signal)
{
    stopWished = true;
    std::signal(signal, SIG_DFL);
}

}   // namespace

void catchStops()
{
    std::signal(SIGINT, onStopSignal);
    std::signal(SIGTERM, onStopSignal);
}

bool isStopWished()
{
    return stopWished;
}

core::Verdict watchWork(std::string_view stage, double fraction)
{
    static const bool isWatched = io::isTerminal(stderr);
    const int percent = static_cast<int>(100.0 * fraction);
    if (isWatched && percent != lastPercent) {
        lastPercent = percent;
        std::fprintf(stderr, "\r\x1b[K%.*s %3d %%", static_cast<int>(stage.size()), stage.data(), percent);
        std::fflush(stderr);
    }
    return isStopWished() ? core::Verdict::Stop : core::Verdict::Continue;
}

void endWatch()
{
    if (lastPercent >= 0) {
        std::fputs("\r\x1b[K", stderr);
        lastPercent = -1;
    }
}

}   // namespace angiopose::app
