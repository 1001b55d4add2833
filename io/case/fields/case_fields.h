#pragma once

#include "io/case/fields/stored_field.h"

#include <string>

namespace angiopose::io {

/// Returns all fields of a case file, one row each. The fields of the shown view are at the top level.
const StoredFields<core::Case>& caseFields();

/// Returns the JSON Schema generated from the rows.
const std::string& caseSchemaText();

/// Returns all keys read and written for a case with this kind of vessel input, nested as in the file.
Json knownCaseKeys(core::VesselInputKind kind);

}   // namespace angiopose::io
