#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

core::InputFile fileFrom(const Json& json);

/// The path relative to `folder`, and the hash if known; null if there is no file.
Json fileJson(const core::InputFile& file, const std::filesystem::path& folder);

}   // namespace angiopose::io
