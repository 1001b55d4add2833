#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the same JSON with indentation, but with arrays of numbers on one line; keeps full double precision.
std::string prettyJson(std::string_view json);

/// Checks that `text` is valid JSON. Fails on a syntax error, with its line number, and on excessive nesting.
core::Status checkJson(std::string_view text, const std::string& path);

/// Returns the members of `json` that are not in `known` (an object of keys, with nested objects for nested keys); ""
/// if all are known.
std::string unknownKeys(std::string_view json, std::string_view known);

/// Returns `json` with those keys of `extra` added that are missing, at every level.
std::string withExtraKeys(std::string_view json, std::string_view extra);

}   // namespace angiopose::io
