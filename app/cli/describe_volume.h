#pragma once

#include "core/support/result.h"

#include <nlohmann/json.hpp>
#include <string>

namespace angiopose::app {

/// Describe 3-D inputs for `info`: the geometry stated in the file and the values derived from it.
core::Result<nlohmann::ordered_json> folderJson(const std::string& path);
core::Result<nlohmann::ordered_json> volumeJson(const std::string& path);
core::Result<nlohmann::ordered_json> dicomVolumeJson(const std::string& path);
core::Result<nlohmann::ordered_json> segmentationJson(const std::string& path);
core::Result<nlohmann::ordered_json> surfaceJson(const std::string& path);

}   // namespace angiopose::app
