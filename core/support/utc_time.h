#pragma once

#include <string>

namespace angiopose::core {

/// Returns the current UTC time in ISO 8601, to the second: "2026-05-04T12:30:00Z".
std::string utcNow();

}   // namespace angiopose::core
