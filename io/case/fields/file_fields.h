#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

core::InputFile fileFrom(const Json& json);

/// Its path relative to `folder`, and its hash where it is known; null where there is no file.
Json fileJson(const core::InputFile& file, const std::filesystem::path& folder);

}   // namespace angiopose::io
