#pragma once

#include <string>

namespace angiopose::core {

/// Returns the current time as ISO 8601, UTC, to the second: "2026-05-04T12:30:00Z".
std::string utcNow();

}   // namespace angiopose::core
