#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/workflow/register_case.h"

namespace angiopose::core {

/// Bends the vessels of a registered case from the poses found, in its registered views together (ALGORITHMS §11).
/// Views and poses of the case stay as they are. `observe` hears every step.
Result<DeformableResult> bendCase(const RegisteredCase& registered, DeformableOptions options = {},
                                  const IterationObserver& observe = {});

}   // namespace angiopose::core
