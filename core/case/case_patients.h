#pragma once

#include "core/case/case.h"

namespace angiopose::core {

/// What speaks against all images of a case, the scan and every angiogram, being of one patient and one side, each
/// thing once. Names nobody.
Messages findMismatch(const Case& theCase);

}   // namespace angiopose::core
