#include "io/support/system/signal_text.h"

#include <unistd.h>
#include <chrono>

namespace angiopose::io {

SignalText& SignalText::operator<<(std::string_view text)
{
    for (const char c : text) {
        if (size_ == line_.size()) {
            flush();
        }
        line_[size_++] = c;
    }
    return *this;
}

SignalText& SignalText::decimal(std::uint64_t value, int minDigits)
{
    return number(value, 10, minDigits);
}

SignalText& SignalText::hexadecimal(std::uintptr_t value)
{
    return *this << "0x", number(value, 16, 1);
}

SignalText& SignalText::number(std::uint64_t value, unsigned base, int minDigits)
{
    std::array<char, 24> digits{};
    std::size_t first = digits.size();
    while (value != 0 || static_cast<int>(digits.size() - first) < minDigits) {
        digits[--first] = "0123456789abcdef"[value % base];
        value /= base;
    }
    return *this << std::string_view(digits.data() + first, digits.size() - first);
}

void SignalText::flush()
{
    for (std::size_t done = 0; done < size_;) {
        const ssize_t written = ::write(file_, line_.data() + done, size_ - done);
        if (written <= 0) {
            break;   // the drive is full: the file remains truncated
        }
        done += static_cast<std::size_t>(written);
    }
    size_ = 0;
}

SignalTime::SignalTime(std::int64_t seconds)
{
    namespace time = std::chrono;
    const time::sys_seconds now{time::seconds(seconds)};
    const auto day = time::floor<time::days>(now);
    const time::year_month_day date(day);
    const time::hh_mm_ss clock(now - day);
    const auto put = [this](std::size_t at, std::uint64_t value, std::size_t count) {
        for (std::size_t i = count; i-- > 0; value /= 10) {
            text[at + i] = static_cast<char>('0' + value % 10);
        }
    };
    constexpr std::string_view form = "0000-00-00T00:00:00Z";
    form.copy(text.data(), form.size());
    put(0, static_cast<std::uint64_t>(static_cast<int>(date.year())), 4);
    put(5, static_cast<unsigned>(date.month()), 2);
    put(8, static_cast<unsigned>(date.day()), 2);
    put(11, static_cast<std::uint64_t>(clock.hours().count()), 2);
    put(14, static_cast<std::uint64_t>(clock.minutes().count()), 2);
    put(17, static_cast<std::uint64_t>(clock.seconds().count()), 2);
}

}   // namespace angiopose::io
