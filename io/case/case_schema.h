#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Where a JSON text breaks the published schema, each in one sentence; empty when it does not.
std::vector<std::string> findSchemaProblems(std::string_view json);

}   // namespace angiopose::io