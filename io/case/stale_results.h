#pragma once

#include "core/case/case.h"
#include "io/case/fields/view_notes.h"

#include <span>

namespace angiopose::io {

/// Removes results and tracking results whose inputs have changed, and adds warnings that name the changes. `noted` is
/// the case as stored, with `notes` on its views in the same order; `read` is the case with its current inputs.
void dropStaleResults(const core::Case& stored, std::span<const ViewNotes> notes, core::Case& read,
                      core::Messages& warnings);

}   // namespace angiopose::io
