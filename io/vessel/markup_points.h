#pragma once

#include "core/support/result.h"
#include "io/vessel/stated_coordinates.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace angiopose::io {

/// How the control points of one of Slicer's markups become LPS mm: the unit as a word or as [code, scheme, meaning],
/// the axes in any case. Fails, naming it, on a unit or axes that are others.
core::Result<CoordinateRule> ruleOf(const nlohmann::ordered_json& markup, const std::string& path);

/// Nothing where the point is not placed. Throws where it is no point.
std::optional<Eigen::Vector3d> placedPoint(const nlohmann::ordered_json& control, const CoordinateRule& rule);

/// `markups` as a file of Slicer.
std::string markupsFile(nlohmann::ordered_json markups);

}   // namespace angiopose::io
