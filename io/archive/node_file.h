#pragma once

#include "io/archive/model/node.h"
#include "io/archive/store/cache.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// What the user entered of archives; shared by window and command line.
struct ArchiveSettings {
    std::vector<ArchiveNode> nodes;
    std::string cacheFolder;   ///< empty: `defaultCacheFolder`
    std::uint64_t cacheBytes = defaultCacheBytes;

    std::string cache() const { return cacheFolder.empty() ? defaultCacheFolder() : cacheFolder; }
};

/// Of the user: $XDG_CONFIG_HOME/AngioPose/archives.json, or that below ~/.config.
std::string defaultNodeFile();

/// FORMATS §7.1. A file that is not there holds no archives. Fails, naming the file, on one that is something else.
core::Result<ArchiveSettings> readArchiveSettings(const std::string& path);

/// Makes its folder where there is none.
core::Status writeArchiveSettings(const ArchiveSettings& settings, const std::string& path);

/// Fails, naming those that are known.
core::Result<ArchiveNode> findNode(const ArchiveSettings& settings, const std::string& name, const std::string& path);

}   // namespace angiopose::io
