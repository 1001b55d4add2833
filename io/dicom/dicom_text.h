#pragma once

#include "core/imaging/angiogram.h"
#include "io/dicom/dicom_dataset.h"

#include <string>

namespace angiopose::io {

/// Converts text to UTF-8 from the character sets of the data set (0008,0005) or, if it has none, of the enclosing one
/// (`declared`); without any, from UTF-8 or, if invalid, Latin-1. Replaces unconvertible characters by "?".
std::string utf8Text(const DicomDataset& data, DicomTag tag, std::string_view declared = {});

/// Returns the patient and study data that the window displays in its corners.
core::StudyIdentity identityOf(const DicomDataset& data);

}   // namespace angiopose::io
