#pragma once

#include "core/support/result.h"
#include "io/deidentify/identity_words.h"
#include "io/deidentify/kept_content.h"
#include "io/dicom/dicom_item.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// What stands in place of names, UIDs and dates: the same for the same original, so that the files of an export fit
/// together, and without the key nobody finds the way back (keyed hashes, HMAC-SHA-256).
class Pseudonyms {
public:
    /// With a random key: exports of different days do not fit together. Fails where the system gives no random bytes.
    static core::Result<Pseudonyms> create();
    /// Exports with the same key fit together; whoever has it can test guesses.
    explicit Pseudonyms(std::string key) : key_(std::move(key)) {}

    /// "2.25." and a number. UIDs that DICOM itself defines stay.
    std::string uid(std::string_view original) const;

    /// "P-" and ten digits, for a patient's ID; where there is none, for the name.
    std::string patient(std::string_view original) const;

    /// yyyymmdd, one to ten years earlier, as many days for all dates of one patient, weeks kept. "" for what is no
    /// date.
    std::string date(std::string_view original, std::string_view patient) const;

private:
    std::string digest(std::string_view role, std::string_view original) const;

    std::string key_;
};

enum class KeptDates { None, Shifted };

/// What takes the places of names, UIDs and dates in one data set.
struct Replacements {
    const Pseudonyms& pseudonyms;
    const IdentityWords& words;
    std::string patient;   ///< by which dates are shifted
    KeptDates dates = KeptDates::None;
    KeptContent* content = nullptr;   ///< of objects that are no images
};

/// Copies the elements that describe the image: numbers, codes and flags of acquisition, geometry and display, UIDs
/// replaced, dates as wished, sequences of these. Everything else stays behind: names, texts, private elements,
/// overlays, curves and what no rule knows; of objects that are no images `content` says what else is copied and what
/// stands in place of words. This is less than PS3.15 table E.1-1 lets through, and so holds for
/// elements to come.
void copyKept(const DicomDataset& from, DicomItem& to, const Replacements& replacements);

}   // namespace angiopose::io
