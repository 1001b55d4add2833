#pragma once

#include "io/dicom/dicom_dataset.h"

#include <map>
#include <string>
#include <string_view>

namespace angiopose::io {

/// A flat data set of texts, as queries are: implicit VR, little endian (PS3.5 7.1.3). Values are padded by a space,
/// UIDs by a zero; where one is not ASCII the set says that its texts are UTF-8.
std::string encodedIdentifier(const std::map<DicomTag, std::string>& values);

/// The data set of an answer in that encoding, as it comes through the gate.
DicomDataset decodedIdentifier(std::string_view bytes);

}   // namespace angiopose::io
