#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace angiopose::io {

/// Writes lines of text to a file inside a signal handler, without allocating memory or taking locks.
class SignalText {
public:
    explicit SignalText(int file) : file_(file) {}
    ~SignalText() { flush(); }
    SignalText(const SignalText&) = delete;
    SignalText& operator=(const SignalText&) = delete;

    SignalText& operator<<(std::string_view text);
    SignalText& decimal(std::uint64_t value, int minDigits = 1);
    SignalText& hexadecimal(std::uintptr_t value);
    void flush();

private:
    SignalText& number(std::uint64_t value, unsigned base, int minDigits);

    int file_;
    std::array<char, 512> line_{};
    std::size_t size_ = 0;
};

/// Formats seconds since 1970 as "2026-01-31T08:05:09Z".
struct SignalTime {
    explicit SignalTime(std::int64_t seconds);
    std::array<char, 21> text{};
};

}   // namespace angiopose::io
