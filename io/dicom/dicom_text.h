#pragma once

#include "core/imaging/angiogram.h"
#include "io/dicom/dicom_dataset.h"

#include <string>

namespace angiopose::io {

/// Bytes in the data set's own character set (0008,0005) as UTF-8; what cannot be converted becomes "?".
std::string utf8Text(const DicomDataset& data, DicomTag tag);

/// Who and when, for the corners of the window.
core::StudyIdentity identityOf(const DicomDataset& data);

}   // namespace angiopose::io