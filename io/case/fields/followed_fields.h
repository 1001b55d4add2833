#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// What following found in the run of a view: poses and what is told of bends. How the points are bent stands in a file
/// beside the case (io/case/followed_bends_file).
StoredField<core::View> followedField();

}   // namespace angiopose::io
