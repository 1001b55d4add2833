#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the same JSON, indented, with arrays of numbers on one line; doubles are restored to the last bit.
std::string prettyJson(std::string_view json);

/// Checks that `text` is usable JSON; fails with the line of the first error, or on excessive nesting.
core::Status checkJson(std::string_view text, const std::string& path);

/// Returns the members of `json` that `known` (an object of keys, nested objects for nested keys) does not mention; ""
/// if none.
std::string unknownKeys(std::string_view json, std::string_view known);

/// Returns `json` with the keys of `extra` that it lacks, at every level.
std::string withExtraKeys(std::string_view json, std::string_view extra);

}   // namespace angiopose::io