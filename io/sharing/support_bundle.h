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

/// What a program can tell of itself: `program.txt` with versions and machine, and the last dumps of faults.
std::vector<SupportText> programTexts(const std::string& furtherFacts = {});

/// The same texts without what the redaction knows.
std::vector<SupportText> cleaned(std::vector<SupportText> texts, const Redaction& redaction);

/// All of them after one another, each below its name: what the user reads before it is written.
std::string asOneText(const std::vector<SupportText>& texts);

/// Puts them into a ZIP archive, atomically.
core::Status writeSupportBundle(const std::vector<SupportText>& texts, const std::string& archivePath);

}   // namespace angiopose::io
