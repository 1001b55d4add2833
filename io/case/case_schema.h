#pragma once

#include "core/support/message.h"

#include <string_view>

namespace angiopose::io {

/// Where a JSON text breaks the published schema, empty where it does not.
core::Messages findSchemaProblems(std::string_view json);

}   // namespace angiopose::io