#pragma once

#include "core/support/result.h"
#include "io/deidentify/kept_elements.h"
#include "io/deidentify/kept_pixels.h"
#include "io/dicom/dicom_file.h"

#include <string>

namespace angiopose::io {

/// What of DICOM can be freed of identity.
enum class FreedClass { Image, Segmentation, Report, PresentationState, Registration };

/// By its SOP class; an image where that tells nothing else. Fails, naming the file, where words or pages of the object
/// cannot be cleared for sure, and where it holds pixels that objects of its class do not have: they would be lost.
core::Result<FreedClass> freedClassOf(const DicomFile& file, const std::string& path);

/// What is wished of files that go to others.
struct Deidentification {
    KeptDates dates = KeptDates::None;
    DrawnLetters letters = DrawnLetters::Told;
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
                                            const Deidentification& wished, const Pseudonyms& pseudonyms);

}   // namespace angiopose::io
