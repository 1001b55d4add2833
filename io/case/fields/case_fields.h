#pragma once

#include "io/case/fields/stored_field.h"

#include <string>

namespace angiopose::io {

/// Everything that a case file keeps: one row each; of its views the shown one stands in the case itself.
const StoredFields<core::Case>& caseFields();

/// The JSON Schema that follows from the rows.
const std::string& caseSchemaText();

/// Every key that is read and written in a case with this kind of vessels; an object holds those of an object.
Json knownCaseKeys(core::VesselInputKind kind);

}   // namespace angiopose::io
