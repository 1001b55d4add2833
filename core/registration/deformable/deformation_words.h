#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <span>

namespace angiopose::core {

/// Decides between rigid, bent and unsure by evidence, spread and what was seen, and says in words what moved
/// (ALGORITHMS §11.4). A rigid verdict puts the rigid poses back.
void judgeDeformation(std::span<const DeformableView> views, DeformableResult& result);

}   // namespace angiopose::core
