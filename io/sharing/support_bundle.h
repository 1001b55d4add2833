#pragma once

#include "core/support/result.h"
#include "io/sharing/redaction.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// A file of a support bundle.
struct SupportFile {
    std::string name;   ///< file name, for example "program.txt"
    std::string text;
};

/// Returns AngioPose's diagnostics: `program.txt` with the versions and the computer, and the latest crash dumps.
std::vector<SupportFile> diagnosticFiles(const std::string& additionalInfo = {});

/// Returns the texts with the identifiers of the redaction removed.
std::vector<SupportFile> redact(std::vector<SupportFile> texts, const Redaction& redaction);

/// Joins all texts, each under its file name, so that the user can review them before the bundle is written.
std::string joinTexts(const std::vector<SupportFile>& texts);

/// Atomically writes the texts into a ZIP archive.
core::Status writeSupportBundle(const std::vector<SupportFile>& texts, const std::string& archivePath);

}   // namespace angiopose::io
