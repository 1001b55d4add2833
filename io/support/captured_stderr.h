#pragma once

#include <cstdio>
#include <mutex>
#include <string>

namespace angiopose::io {

/// Keeps what a library prints to the terminal, for the few that cannot be told not to: while one lives, stderr of the
/// whole process goes there. One at a time; others wait. Where it cannot be had, stderr stays as it is.
class CapturedStderr {
public:
    CapturedStderr();
    ~CapturedStderr();
    CapturedStderr(const CapturedStderr&) = delete;
    CapturedStderr& operator=(const CapturedStderr&) = delete;

    std::string text();   ///< so far

private:
    std::unique_lock<std::mutex> turn_;
    std::FILE* kept_ = nullptr;
    int stderr_ = -1;   ///< a second way to where it went before
};

}   // namespace angiopose::io