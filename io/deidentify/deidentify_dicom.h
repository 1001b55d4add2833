#pragma once

#include "core/support/result.h"
#include "io/deidentify/copy_pixels.h"
#include "io/deidentify/permitted_elements.h"

#include <string>

namespace angiopose::io {

/// Options for de-identification.
struct DeidentificationOptions {
    DatePolicy dates = DatePolicy::None;
    BurnedInTextPolicy letters = BurnedInTextPolicy::Reported;
    std::string patientName{};   ///< replaces the patient name and ID; if empty, a pseudonym is used
};

/// A de-identified DICOM object.
struct DeidentifiedDicom {
    std::string content;   ///< bytes of the DICOM file
    std::string seriesUid;   ///< new UID that replaces the original
    int instanceNumber = 0;   ///< unchanged instance number; 0 if absent
    core::Messages warnings;
};

/// De-identifies the image, segmentation, report, presentation state or spatial registration of a DICOM file by the
/// Basic Application Level Confidentiality Profile (PS3.15 annex E): applies `copyPermittedElements` and `copyPixels`,
/// replaces patient and study by pseudonyms, and states the applied methods as standard codes. Fails and names the file
/// if it contains no image that can be stored again, or if parts of it cannot be cleared reliably.
core::Result<DeidentifiedDicom> deidentifyDicom(const DicomFile& file, const std::string& path,
                                                const DeidentificationOptions& requested, const Pseudonyms& pseudonyms);

}   // namespace angiopose::io
