#pragma once

#include "io/deidentify/identity_words.h"
#include "io/deidentify/kept_content.h"
#include "io/deidentify/pseudonyms.h"
#include "io/dicom/dicom_item.h"

namespace angiopose::io {

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
