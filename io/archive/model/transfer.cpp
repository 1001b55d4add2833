#include "io/archive/model/transfer.h"

#include <array>
#include <cstdio>

namespace angiopose::io {

std::string sizeText(std::uint64_t bytes)
{
    constexpr std::array units = {"bytes", "kB", "MB", "GB", "TB"};
    auto value = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (value >= 1000.0 && unit + 1 < units.size()) {
        value /= 1000.0;
        ++unit;
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g %s", value, units.at(unit));
    return text.data();
}

std::string statusText(unsigned status)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%04X", status & 0xffffU);
    return text.data();
}

}   // namespace angiopose::io
