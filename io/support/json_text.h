#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// The same JSON, indented, with arrays of numbers on one line; doubles restore to the last bit.
std::string prettyJson(std::string_view json);

/// Checks that `text` is JSON that can be worked on; fails with the line of the first mistake, or on absurd nesting.
core::Status checkJson(std::string_view text, const std::string& path);

/// What `json` has and `known` (an object of keys, nested objects for nested keys) does not mention; "" when nothing.
std::string unknownKeys(std::string_view json, std::string_view known);

/// `json` with the keys of `extra` that it does not have itself, at every level.
std::string withExtraKeys(std::string_view json, std::string_view extra);

}   // namespace angiopose::io