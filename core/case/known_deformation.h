#pragma once

#include "core/case/vessels.h"
#include "core/case/view.h"

#include <memory>

namespace angiopose::core {

/// Returns the deformation of the view, from deformable registration or from tracking the cine run, if it applies at
/// `pose`: it was found from this pose, belongs to this tree and is visible. Otherwise returns null.
std::shared_ptr<const DeformableResult> knownDeformation(const View& view, const Vessels& vessels,
                                                         const RigidTransform& pose);

}   // namespace angiopose::core
