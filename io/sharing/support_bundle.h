#pragma once

#include "core/support/result.h"
#include "io/sharing/redaction.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// A file of a support bundle.
struct SupportText {
    std::string name;   ///< "program.txt"
    std::string text;
};

/// Returns the program's own diagnostics: `program.txt` with versions and machine, and the latest crash dumps.
std::vector<SupportText> programTexts(const std::string& furtherFacts = {});

/// Returns the same texts without the identifiers that the redaction knows.
std::vector<SupportText> cleaned(std::vector<SupportText> texts, const Redaction& redaction);

/// Joins all texts, each below its name, for the user to review before writing.
std::string asOneText(const std::vector<SupportText>& texts);

/// Writes the texts into a ZIP archive, atomically.
core::Status writeSupportBundle(const std::vector<SupportText>& texts, const std::string& archivePath);

}   // namespace angiopose::io
