#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <span>

namespace angiopose::core {

/// Decides between Rigid, Deformed and Unsure from the evidence, the spread of the fits and the matched fraction of the
/// visible tree, and describes the motion in messages (ALGORITHMS §11.4). A Rigid verdict restores the rigid poses.
void classifyDeformation(std::span<const DeformableView> views, DeformableResult& result);

}   // namespace angiopose::core
