#pragma once

#include "io/deidentify/identity_words.h"
#include "io/dicom/dicom_dataset.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Value, scheme and meaning of a coded term (PS3.3 8.8), as read.
struct ReadTerm {
    std::string value;
    std::string scheme;
    std::string meaning;
};

/// What a term becomes that goes to others.
struct KeptTerm {
    ReadTerm term;
    bool isReplaced = false;   ///< by one that says it was taken out
};

/// Values stay where the scheme is a public one and they look as its values do; of units and of this program's own
/// terms those that are known. Meanings are free words: the known ones stay, in place of others stands the value.
KeptTerm keptTerm(const ReadTerm& term, const IdentityWords& words);

/// What objects that are no images hold besides what describes images: segments, graphics, matrices, references, the
/// tree of a report (PS3.15 E.3.6, clean structured content; E.3.3, clean graphics). Codes, numbers and structure stay,
/// words are replaced, so that what must be there is there and positions hold. For one object.
class KeptContent {
public:
    explicit KeptContent(const IdentityWords& words) : words_(words) {}

    /// Whether an element is copied, numbers and codes by the usual rules.
    static bool has(DicomTag tag);

    /// Whether a text is one for `insteadOf`.
    static bool isReplaced(DicomTag tag);
    std::string insteadOf(DicomTag tag, const std::vector<std::string>& values);

    /// In place of a date or time that does not stay, where there must be one; nothing where there need not be.
    static std::optional<std::string> insteadOfTime(DicomTag tag, const std::string& vr);

    ReadTerm term(const ReadTerm& term);

    /// Words, names and terms that were taken out.
    std::size_t cleared() const { return cleared_; }

private:
    std::string layer(const std::string& name);
    std::string segmentLabel(const std::string& label);
    std::string words(const std::string& text);

    const IdentityWords& words_;
    std::map<std::string, std::string> layers_;   ///< graphics refer to them by name
    std::size_t segments_ = 0;
    std::size_t cleared_ = 0;
};

}   // namespace angiopose::io
