#pragma once

#include "core/support/result.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// A series that was retrieved.
struct CachedSeries {
    std::string studyUid;
    std::string seriesUid;
    std::string folder;
    std::size_t objects = 0;
    std::uint64_t bytes = 0;
    std::chrono::system_clock::time_point usedAt;
    bool isWhole = true;   ///< false: a retrieval ended before all had come
};

/// What the cache holds, longest unused first. Files that are not its own are not seen.
std::vector<CachedSeries> cachedSeries(const std::string& root);

/// Drops the series longest unused until no more than `maxBytes` are left; never that in the folder `kept`. What is
/// left, in bytes.
std::uint64_t shrinkCache(const std::string& root, std::uint64_t maxBytes, const std::string& kept = {});

/// Drops all that the cache holds, and nothing that is not its own. How many objects went.
core::Result<std::size_t> emptyCache(const std::string& root);

/// Says that a series is wanted now, and whether all of it is there.
void markSeriesBegun(const std::string& folder);
void markSeriesWhole(const std::string& folder);

/// Of the user: $XDG_CACHE_HOME/angiopose/archive, or that below ~/.cache.
std::string defaultCacheFolder();

inline constexpr std::uint64_t defaultCacheBytes = 20'000'000'000;
inline constexpr std::uint64_t defaultObjectBytes = 4'000'000'000;   ///< of one object

}   // namespace angiopose::io
