#pragma once

#include "core/imaging/angiogram.h"
#include "io/dicom/dicom_dataset.h"

#include <string>

namespace angiopose::io {

/// Bytes in the data set's own character sets (0008,0005), or in those `declared` around it, as UTF-8; without any they
/// are UTF-8 where they can be, else Latin-1. What cannot be converted becomes "?".
std::string utf8Text(const DicomDataset& data, DicomTag tag, std::string_view declared = {});

/// Who and when, for the corners of the window.
core::StudyIdentity identityOf(const DicomDataset& data);

}   // namespace angiopose::io