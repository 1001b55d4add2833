#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

core::InputFile fileFrom(const Json& json);

/// Returns the path relative to `folder` and, if known, the hash; null if there is no file.
Json fileJson(const core::InputFile& file, const std::filesystem::path& folder);

}   // namespace angiopose::io
