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

/// Returns the files with the identifiers of the redaction removed from their text.
std::vector<SupportFile> redact(std::vector<SupportFile> texts, const Redaction& redaction);

/// Joins the text of all files, each under its file name, so that the user can review it before the bundle is written.
std::string joinTexts(const std::vector<SupportFile>& texts);

/// Atomically writes the files into a ZIP archive.
core::Status writeSupportBundle(const std::vector<SupportFile>& texts, const std::string& archivePath);

}   // namespace angiopose::io
