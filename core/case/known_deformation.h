#pragma once

#include "core/case/vessels.h"
#include "core/case/view.h"

#include <memory>

namespace angiopose::core {

/// What bending found for a view, or following its run for one of the frames, and holds where its vessels are seen at
/// `pose`: that is the pose from which it was found, it is of this tree, and there is something to see. Else null.
std::shared_ptr<const DeformableResult> knownDeformation(const View& view, const Vessels& vessels,
                                                         const RigidTransform& pose);

}   // namespace angiopose::core
