#pragma once

#include "core/case/case.h"
#include "io/opening/read_inputs.h"

#include <string>

namespace angiopose::io {

/// What was opened as another view of the case's vessels: an angiogram, or the image of a whole case, which `path` then
/// is. Its pose is where the geometry between the views puts the vessels now; where that is not known, its start pose.
/// Fails where there is no angiogram in it.
core::Result<core::View> viewFrom(const core::Case& session, const LoadedInputs& inputs, const std::string& path);

}   // namespace angiopose::io
