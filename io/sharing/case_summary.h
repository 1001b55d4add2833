#pragma once

#include "core/case/case.h"
#include "io/sharing/redaction.h"

#include <string>

namespace angiopose::io {

/// Has a redaction know whom and what a case tells of: paths, what was typed, and what its headers said.
void addIdentifiers(const core::Case& session, Redaction& redaction);

/// The same of an input file, or of the first file of a folder: its path and, of a DICOM file, every text, name, UID
/// and date in it. A file that cannot be read gives its path alone.
void addIdentifiersOfFile(const std::string& path, Redaction& redaction);

/// What a case is made of, as "key: value" in lines: kinds, sizes, counts, options that are not as usual, what the
/// verdicts say by their ids. Nothing that was typed, no name, date, path or UID.
std::string caseSummary(const core::Case& session);

}   // namespace angiopose::io
