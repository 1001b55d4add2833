#pragma once

#include "core/imaging/angiogram.h"

#include <nlohmann/json.hpp>

namespace angiopose::app {

nlohmann::ordered_json cameraJson(const core::ProjectionCamera& camera);

/// Lists each C-arm value with its origin, the resulting camera, contradictory and missing values, and every geometry
/// element of the image's header.
nlohmann::ordered_json geometryJson(const core::CArm& cArm, const core::Angiogram& angiogram);

}   // namespace angiopose::app
