#pragma once

#include "core/support/result.h"
#include "io/deidentify/kept_elements.h"
#include "io/deidentify/kept_pixels.h"

#include <string>

namespace angiopose::io {

/// What is wished of files that go to others.
struct Deidentification {
    KeptDates dates = KeptDates::None;
    DrawnLetters letters = DrawnLetters::Reported;
    std::string patientName{};   ///< and ID; empty: a pseudonym
};

/// A DICOM object without identity.
struct NamelessDicom {
    std::string content;   ///< of the file
    std::string seriesUid;   ///< new
    int instanceNumber = 0;   ///< as it was; 0: not given
    core::Messages warnings;
};

/// The image, segmentation, report, presentation state or spatial registration of a DICOM file after the Basic
/// Application Level Confidentiality Profile (PS3.15 annex E): `copyKept`, `copyPixels`, patient and study by
/// pseudonyms, what was done said in the codes of the standard. Fails naming the file where it holds no image that can
/// be stored again, or what cannot be cleared for sure.
core::Result<NamelessDicom> withoutIdentity(const DicomFile& file, const std::string& path,
                                            const Deidentification& requested, const Pseudonyms& pseudonyms);

}   // namespace angiopose::io
