#pragma once

#include "io/archive/model/node.h"
#include "io/archive/store/cache.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// The user's archive settings, shared by the window and the command line.
struct ArchiveSettings {
    std::vector<ArchiveNode> nodes;
    std::string cacheFolder;   ///< empty: `defaultCacheFolder`
    std::uint64_t cacheBytes = defaultCacheBytes;

    std::string cache() const { return cacheFolder.empty() ? defaultCacheFolder() : cacheFolder; }
};

/// The user's settings file: $XDG_CONFIG_HOME/AngioPose/archives.json, or the same path below ~/.config.
std::string defaultNodeFile();

/// Reads the settings file (FORMATS §7.1). A missing file means no archives. Fails, naming the file, if its content is
/// not valid.
core::Result<ArchiveSettings> readArchiveSettings(const std::string& path);

/// Writes the settings file and creates its folder if needed.
core::Status writeArchiveSettings(const ArchiveSettings& settings, const std::string& path);

/// Finds an archive by name; fails with the list of known names.
core::Result<ArchiveNode> findNode(const ArchiveSettings& settings, const std::string& name, const std::string& path);

}   // namespace angiopose::io
