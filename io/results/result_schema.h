#pragma once

#include <string>

namespace angiopose::io {

/// Returns the JSON Schema of `result.json`, as published in resources/.
const std::string& resultSchema();

}   // namespace angiopose::io
