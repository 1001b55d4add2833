#pragma once

#include "core/case/case.h"
#include "io/sharing/redaction.h"

#include <string>

namespace angiopose::io {

/// Adds everything in a case that can identify a person to a redaction: paths, user-entered text and header values.
void addIdentifiers(const core::Case& session, Redaction& redaction);

/// Adds the identifiers of an input file, or of the first file of a folder: the path and, for a DICOM file, every
/// string, name, UID and date in it. Adds only the path if the file is unreadable.
void addIdentifiersOfFile(const std::string& path, Redaction& redaction);

/// Summarizes a case as "key: value" lines: kinds, sizes, counts, non-default options, and the IDs of its messages.
/// Contains no user-entered text, names, dates, paths or UIDs.
std::string caseSummary(const core::Case& session);

}   // namespace angiopose::io
