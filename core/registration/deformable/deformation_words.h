#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <span>

namespace angiopose::core {

/// Decides between rigid, bent and unsure from the evidence, the spread and the visible share, and describes the motion
/// in messages (ALGORITHMS §11.4). A rigid verdict restores the rigid poses.
void judgeDeformation(std::span<const DeformableView> views, DeformableResult& result);

}   // namespace angiopose::core
