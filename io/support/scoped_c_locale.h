#pragma once

#include <locale.h>
#include <clocale>

namespace angiopose::io {

/// Scope in which libraries that parse numbers through `strtod` or `sscanf` use "." as the decimal point. Affects only
/// this thread, not the locale of the program.
class ScopedCLocale {
public:
    ScopedCLocale() : previous_(uselocale(plain())) {}
    ScopedCLocale(const ScopedCLocale&) = delete;
    ScopedCLocale& operator=(const ScopedCLocale&) = delete;
    ~ScopedCLocale() { uselocale(previous_); }

private:
    static locale_t plain()
    {
        static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
        return locale;
    }

    locale_t previous_;
};

}   // namespace angiopose::io
