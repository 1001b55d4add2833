#pragma once

#include "core/case/case.h"
#include "io/opening/read_inputs.h"

#include <string>

namespace angiopose::io {

/// Returns an additional view of the case's vessels made from the opened files: an angiogram, or the image of a whole
/// case (at `path`). The pose follows from the geometry between the views; if the geometry is unknown, the view starts
/// at its initial pose. Fails if there is no angiogram.
core::Result<core::View> viewFromInputs(const core::Case& session, const LoadedInputs& inputs, const std::string& path);

}   // namespace angiopose::io
