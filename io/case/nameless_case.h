#pragma once

#include "core/case/case.h"

#include <cstddef>

namespace angiopose::io {

/// Removes user-entered texts and unknown keys from a case: title, notes, authors, times, text annotations, and names
/// of views, snapshots, marks, landmarks and measurements. Required texts become numbers; branch names stay because
/// they are anatomy. Returns the number of removed texts.
std::size_t clearTexts(core::Case& session);

/// Removes texts and input file names from a case; the content hashes still identify the inputs. The images are not
/// changed.
core::Case namelessCase(core::Case session);

}   // namespace angiopose::io
