#include "app/cli/shard.h"

#include "app/messages/messages.h"

#include <charconv>

namespace angiopose::app {

core::Result<core::Shard> parseShard(const std::string& text)
{
    std::uint64_t part = 0;
    std::uint64_t count = 0;
    const char* const end = text.data() + text.size();
    const auto [slash, partError] = std::from_chars(text.data(), end, part);
    const bool hasSlash = partError == std::errc{} && slash != end && *slash == '/';
    if (hasSlash) {
        const auto [rest, countError] = std::from_chars(slash + 1, end, count);
        if (countError == std::errc{} && rest == end && part >= 1 && part <= count) {
            return core::Shard{part - 1, count};
        }
    }
    return core::Error(messages::shardUnclear(text));
}

}   // namespace angiopose::app
