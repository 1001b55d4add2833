#pragma once

#include "core/case/view.h"

namespace angiopose::core {

/// Whether the images of a view's result contradict the camera it has; `viewCount`: so many views were registered
/// together.
bool isGeometryContradicted(const View& view, std::size_t viewCount);

/// Gives the view the camera that its result's images show; the error that the camera had. Nothing where it is the one
/// that they show, within half a σ of what they leave open.
std::optional<CameraError> takeGeometryOfImages(View& view);

}   // namespace angiopose::core
