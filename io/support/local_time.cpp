#include "io/support/local_time.h"

#include <array>
#include <ctime>

namespace angiopose::io {

LocalTime localTimeNow()
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    std::array<char, 32> text{};
    const std::string all(text.data(), std::strftime(text.data(), text.size(), "%Y%m%d%H%M%S", &parts));
    return {all.substr(0, 8), all.substr(8)};
}

}   // namespace angiopose::io
