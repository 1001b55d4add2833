#pragma once

#include "core/case/case.h"

#include <cstddef>

namespace angiopose::io {

/// Removes user-entered text and unknown keys from a case: title, notes, authors, times, text annotations, and names of
/// views, snapshots, marks, landmarks and measurements. Replaces required strings by numbers; keeps branch names
/// because they are anatomical terms. Returns the number of removed strings.
std::size_t removeFreeText(core::Case& session);

/// Removes user-entered text and input file names from a case; the content hashes still identify the inputs. Does not
/// change the images.
core::Case deidentifyCase(core::Case session);

}   // namespace angiopose::io
