#pragma once

#include "core/support/result.h"
#include "io/deidentify/identity_words.h"
#include "io/deidentify/kept_content.h"
#include "io/dicom/dicom_item.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Replacements for names, UIDs and dates. Equal originals get equal replacements, which keeps the files of an export
/// consistent; without the key they cannot be reversed (keyed hashes, HMAC-SHA-256).
class Pseudonyms {
public:
    /// Creates pseudonyms with a random key, which makes separate exports unlinkable. Fails if the system provides no
    /// random bytes.
    static core::Result<Pseudonyms> create();
    /// Exports with the same key are linkable; anyone who has the key can test guesses.
    explicit Pseudonyms(std::string key) : key_(std::move(key)) {}

    /// Replaces a UID by "2.25." and a number; keeps UIDs defined by DICOM.
    std::string uid(std::string_view original) const;

    /// Replaces a patient ID, or a name without an ID, by "P-" and ten digits.
    std::string patient(std::string_view original) const;

    /// Shifts a date (yyyymmdd) by one to ten years into the past, by whole weeks and by the same number of days for
    /// all dates of a patient. Returns "" for an invalid date.
    std::string date(std::string_view original, std::string_view patient) const;

private:
    std::string digest(std::string_view role, std::string_view original) const;

    std::string key_;
};

enum class DatePolicy { None, Shifted };

/// Replacements for names, UIDs and dates in one data set.
struct Replacements {
    const Pseudonyms& pseudonyms;
    const IdentityWords& words;
    std::string patient;   ///< determines the shift of the dates
    DatePolicy dates = DatePolicy::None;
    KeptContent* content = nullptr;   ///< for objects other than images
};

/// Copies the elements that describe the image: numbers, codes and flags of acquisition, geometry and display, UIDs
/// replaced, dates as requested, and sequences of these. Omits everything else: names, texts, private elements,
/// overlays, curves and unknown elements; for objects other than images, `content` selects further elements and
/// replaces their words. Stricter than PS3.15 table E.1-1 and therefore safe for future elements.
void copyKept(const DicomDataset& from, DicomItem& to, const Replacements& replacements);

}   // namespace angiopose::io
