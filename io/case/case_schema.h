#pragma once

#include "core/support/message.h"

#include <string_view>

namespace angiopose::io {

/// Lists the violations of the published schema in a JSON text; empty if the text conforms.
core::Messages findSchemaProblems(std::string_view json);

}   // namespace angiopose::io
