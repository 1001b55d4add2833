#pragma once

#include "io/deidentify/identity_words.h"
#include "io/dicom/dicom_dataset.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Coded term as read: value, coding scheme and meaning (PS3.3 8.8).
struct CodedEntry {
    std::string value;
    std::string scheme;
    std::string meaning;
};

/// A coded term after de-identification.
struct DeidentifiedTerm {
    CodedEntry term;
    bool isReplaced = false;   ///< whether the term was replaced by one that states the removal
};

/// De-identifies a coded term. Keeps values of public schemes that have the scheme's format; among units and this
/// program's own terms, only known ones. Meanings are free text: keeps known ones and replaces others by the value.
DeidentifiedTerm deidentifyTerm(const CodedEntry& term, const IdentityWords& words);

/// De-identifies the content specific to objects other than images: segments, graphics, matrices, references, report
/// trees (PS3.15 E.3.6, clean structured content; E.3.3, clean graphics). Keeps codes, numbers and structure but
/// replaces words, so that required elements and item positions are preserved. Each object requires its own instance.
class ContentCleaner {
public:
    explicit ContentCleaner(const IdentityWords& words) : words_(words) {}

    /// Returns whether an element is copied; the general rules apply to its numbers and codes.
    static bool has(DicomTag tag);

    /// Returns whether the text of an element must be replaced by `replacementFor`.
    static bool isReplaced(DicomTag tag);
    std::string replacementFor(DicomTag tag, const std::vector<std::string>& values);

    /// Returns the replacement for a removed date or time that must be present; nullopt if the element is optional.
    static std::optional<std::string> replacementForTime(DicomTag tag, const std::string& vr);

    CodedEntry term(const CodedEntry& term);

    /// Returns the number of removed words, names and terms.
    std::size_t removedCount() const { return removedCount_; }

private:
    std::string cleanLayer(const std::string& name);
    std::string cleanSegmentLabel(const std::string& label);
    std::string words(const std::string& text);

    const IdentityWords& words_;
    std::map<std::string, std::string> layers_;   ///< layer names, to which graphics refer
    std::size_t segments_ = 0;
    std::size_t removedCount_ = 0;
};

}   // namespace angiopose::io
