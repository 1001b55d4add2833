#pragma once

#include "core/support/result.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// A retrieved series.
struct CachedSeries {
    std::string studyUid;
    std::string seriesUid;
    std::string folder;
    std::size_t objects = 0;
    std::uint64_t bytes = 0;
    std::chrono::system_clock::time_point lastUsed;
    bool isComplete = true;   ///< false if retrieval ended before all objects had arrived
};

/// Lists the cached series, least recently used first. Ignores files that the cache did not create.
std::vector<CachedSeries> listCachedSeries(const std::string& root);

/// Deletes the least recently used series, except the one in the folder `kept`, until at most `maxBytes` remain.
/// Returns the remaining size in bytes.
std::uint64_t shrinkCache(const std::string& root, std::uint64_t maxBytes, const std::string& keptFolder = {});

/// Deletes everything that the cache created and no other files. Returns the number of deleted objects.
core::Result<std::size_t> clearCache(const std::string& root);

/// Mark a series as recently used: the first function as incomplete, the second as complete.
void markSeriesIncomplete(const std::string& folder);
void markSeriesComplete(const std::string& folder);

/// Returns the user's cache folder: $XDG_CACHE_HOME/angiopose/archive, or the same path below ~/.cache.
std::string defaultCacheFolder();

inline constexpr std::uint64_t defaultCacheBytes = 20'000'000'000;
inline constexpr std::uint64_t defaultMaxObjectBytes = 4'000'000'000;   ///< size limit of one object, bytes

}   // namespace angiopose::io
