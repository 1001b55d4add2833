#pragma once

#include <locale.h>
#include <clocale>

namespace angiopose::io {

/// Scope in which libraries that parse numbers through `strtod` or `sscanf` use "." as the decimal point. Affects only
/// this thread, not the locale of the program.
class DecimalPoint {
public:
    DecimalPoint() : before_(uselocale(plain())) {}
    DecimalPoint(const DecimalPoint&) = delete;
    DecimalPoint& operator=(const DecimalPoint&) = delete;
    ~DecimalPoint() { uselocale(before_); }

private:
    static locale_t plain()
    {
        static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
        return locale;
    }

    locale_t before_;
};

}   // namespace angiopose::io
