#pragma once

#include "core/case/case.h"
#include "io/case/fields/view_notes.h"

#include <span>

namespace angiopose::io {

/// Lets go of results, and of what following found, that stand beside other inputs than those they were found with.
/// `noted`: the case as its file has it, with `notes` of its views, in order; `read`: with the inputs as they are.
/// Warns of each, saying what has changed.
void dropStaleResults(const core::Case& noted, std::span<const ViewNotes> notes, core::Case& read,
                      core::Messages& warnings);

}   // namespace angiopose::io
