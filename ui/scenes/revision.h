#pragma once

#include <atomic>
#include <cstdint>

namespace angiopose::ui {

/// A number that no state of anything shown had before: equal revisions, equal content, whoever holds it.
inline std::uint64_t nextRevision()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}   // namespace angiopose::ui
