#pragma once

#include "core/imaging/angiogram.h"
#include "io/dicom/dicom_dataset.h"

#include <string>

namespace angiopose::io {

/// Converts a text to UTF-8 from the data set's character sets (0008,0005), or from those `declared` around it; without
/// any, from UTF-8 if valid, otherwise from Latin-1. Replaces unconvertible characters by "?".
std::string utf8Text(const DicomDataset& data, DicomTag tag, std::string_view declared = {});

/// Returns the patient and study data that the window displays in its corners.
core::StudyIdentity identityOf(const DicomDataset& data);

}   // namespace angiopose::io
