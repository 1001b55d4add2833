#pragma once

#include "io/archive/model/node.h"
#include "io/archive/store/cache.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::io {

/// The user's archive settings, shared by the GUI and the command line.
struct ArchiveSettings {
    std::vector<ArchiveNode> nodes;
    std::string cacheFolder;   ///< if empty, `defaultCacheFolder`
    std::uint64_t cacheBytes = defaultCacheBytes;

    std::string cache() const { return cacheFolder.empty() ? defaultCacheFolder() : cacheFolder; }
};

/// Returns the user's settings file: $XDG_CONFIG_HOME/AngioPose/archives.json, or the same path below ~/.config.
std::string defaultArchiveSettingsFile();

/// Reads the settings file (FORMATS §7.1). If the file is missing, there are no archives. Fails and names the file if
/// its contents are invalid.
core::Result<ArchiveSettings> readArchiveSettings(const std::string& path);

/// Writes the settings file and creates its parent folder if needed.
core::Status writeArchiveSettings(const ArchiveSettings& settings, const std::string& path);

/// Finds an archive by name; the error for an unknown name lists the known names.
core::Result<ArchiveNode> findNode(const ArchiveSettings& settings, const std::string& name, const std::string& path);

}   // namespace angiopose::io
