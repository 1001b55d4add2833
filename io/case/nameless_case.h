#pragma once

#include "core/case/case.h"

#include <cstddef>

namespace angiopose::io {

/// Takes out of a case what people typed and what this version does not know: title, notes, authors, times, names of
/// views, snapshots, marks, landmarks and measurements, words on images; a number takes the place of what must have a
/// text. How many there were. Branches keep their names, which are anatomy.
std::size_t clearTexts(core::Case& session);

/// Without texts and names of input files, whose content still tells which they are. Images keep what they say.
core::Case namelessCase(core::Case session);

}   // namespace angiopose::io
