#pragma once

#include "core/support/result.h"
#include "io/deidentify/content_cleaner.h"
#include "io/deidentify/identity_words.h"
#include "io/dicom/dicom_item.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Creates replacements for names, UIDs and dates. Equal originals get equal replacements, so that the files of an
/// export stay consistent. The replacements are keyed hashes (HMAC-SHA-256) and cannot be reversed without the key.
class Pseudonyms {
public:
    /// Creates pseudonyms with a random key, so that separate exports cannot be linked. Fails if the system provides no
    /// random bytes.
    static core::Result<Pseudonyms> create();
    /// Exports with the same key are linkable; anyone who has the key can test guesses.
    explicit Pseudonyms(std::string key) : key_(std::move(key)) {}

    /// Replaces a UID by "2.25." and a number; keeps UIDs that the DICOM standard defines.
    std::string uid(std::string_view original) const;

    /// Replaces a patient ID, or the name if there is no ID, by "P-" and ten digits.
    std::string patient(std::string_view original) const;

    /// Shifts a date (yyyymmdd) into the past by a whole number of weeks, one to ten years in total. All dates of a
    /// patient are shifted by the same number of days. Returns "" for an invalid date.
    std::string date(std::string_view original, std::string_view patient) const;

private:
    std::string digest(std::string_view role, std::string_view original) const;

    std::string key_;
};

enum class DatePolicy { None, Shifted };

/// Replacements for the names, UIDs and dates of one data set.
struct Replacements {
    const Pseudonyms& pseudonyms;
    const IdentityWords& words;
    std::string patient;   ///< patient ID or name, which determines the date shift
    DatePolicy dates = DatePolicy::None;
    ContentCleaner* content = nullptr;   ///< required for objects other than images
};

/// Copies the elements that describe the image: numbers, codes and flags of acquisition, geometry and display, UIDs
/// replaced, dates as requested, and sequences of these. Omits everything else: names, text, private elements,
/// overlays, curves and unknown elements; for objects other than images, `content` selects further elements and
/// replaces their words. Stricter than PS3.15 table E.1-1 and therefore safe for future elements.
void copyPermittedElements(const DicomDataset& from, DicomItem& to, const Replacements& replacements);

}   // namespace angiopose::io
