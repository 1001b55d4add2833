#pragma once

#include <atomic>
#include <cstdint>

namespace angiopose::ui {

/// Returns a number that was never used before: equal revisions mean equal content across all objects.
inline std::uint64_t nextRevision()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}   // namespace angiopose::ui
