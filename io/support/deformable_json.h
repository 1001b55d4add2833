#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <string>

namespace angiopose::io {

/// `deformable` of a result (FORMATS §3.5), as text.
std::string deformableJson(const core::DeformableResult& bent);

}   // namespace angiopose::io
