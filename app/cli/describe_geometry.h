#pragma once

#include "core/imaging/angiogram.h"

#include <nlohmann/json.hpp>

namespace angiopose::app {

nlohmann::ordered_json cameraJson(const core::ProjectionCamera& camera);

/// Each value of the C-arm with its origin, the camera that follows, what contradicts and what is missing, and every
/// geometry element of the image's header.
nlohmann::ordered_json geometryJson(const core::CArm& cArm, const core::Angiogram& angiogram);

}   // namespace angiopose::app