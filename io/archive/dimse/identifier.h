#pragma once

#include "io/dicom/dicom_dataset.h"

#include <map>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Encodes a flat query identifier of text elements as implicit VR little endian (PS3.5 7.1.3). Pads values with a
/// space and UIDs with a null byte; declares UTF-8 as the specific character set if any value is not ASCII.
std::string encodeIdentifier(const std::map<DicomTag, std::string>& values);

/// Decodes the identifier of a response (implicit VR little endian), filtered by `filterElements`.
DicomDataset decodeIdentifier(std::string_view bytes);

}   // namespace angiopose::io
