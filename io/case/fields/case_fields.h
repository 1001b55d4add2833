#pragma once

#include "io/case/fields/stored_field.h"

#include <string>

namespace angiopose::io {

/// All fields of a case file, one row each; the shown view is stored in the case itself.
const StoredFields<core::Case>& caseFields();

/// The JSON Schema generated from the rows.
const std::string& caseSchemaText();

/// All keys read and written in a case with this kind of vessels; nested objects hold the keys of nested objects.
Json knownCaseKeys(core::VesselInputKind kind);

}   // namespace angiopose::io
