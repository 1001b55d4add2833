#pragma once

#include "core/case/view.h"

namespace angiopose::core {

/// Whether the camera estimated in the view's result contradicts the camera of the view; `viewCount` is the number of
/// views registered together.
bool isGeometryContradicted(const View& view, std::size_t viewCount);

/// Applies the camera estimated in the view's result and returns the error of the previous camera. Returns nullopt if
/// every parameter differs by less than half the standard deviation of its estimate.
std::optional<CameraError> applyEstimatedGeometry(View& view);

}   // namespace angiopose::core
