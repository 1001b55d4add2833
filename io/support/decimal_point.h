#pragma once

#include <locale.h>
#include <clocale>

namespace angiopose::io {

/// While it lives, libraries that parse numbers by `strtod` or `sscanf` take "." for the decimal point in this thread,
/// whatever the locale of the program around them, which it leaves as it is.
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
