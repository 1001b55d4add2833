#include "io/support/crash_dumps.h"

#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string_view>
#include <thread>

// A program that crashes in the way given on its command line, to test the dump.
namespace {

int* volatile nowhere = nullptr;
volatile int zero = 0;
volatile int some = 7;

[[gnu::noinline]] int crashOnPurpose(std::string_view way)
{
    if (way == "segv") {
        return *nowhere;
    }
    if (way == "fpe") {
        return some / zero;
    }
    if (way == "ill") {
        __builtin_trap();
    }
    if (way == "bus") {
        return std::raise(SIGBUS) + zero;   // not the last call, so that it appears on the stack
    }
    if (way == "terminate") {
        throw std::runtime_error("Jane Doe's study");
    }
    std::abort();
}

// NOLINTNEXTLINE(misc-no-recursion): that is what it is for
[[gnu::noinline]] int fillStack(int depth)
{
    volatile char room[4096];
    room[depth % 4096] = static_cast<char>(depth);
    return zero == 0 ? fillStack(depth + 1) + room[0] : 0;
}

}   // namespace

int main(int count, char** words)
{
    const std::string_view way = count > 1 ? words[1] : "";
    angiopose::io::enableCrashDumps("angiopose-test");
    if (way == "thread") {
        std::thread([] { std::printf("%d", crashOnPurpose("segv")); }).join();
    }
    std::printf("%d", way == "stack" ? fillStack(0) : crashOnPurpose(way));
    return 0;
}
