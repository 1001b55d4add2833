#pragma once

#include "io/dicom/dicom_item.h"

namespace angiopose::io {

/// Term from a coding scheme (PS3.3 8.8).
struct CodedTerm {
    const char* value;
    const char* scheme;
    const char* meaning;
};

/// Adds the term as an item of a code sequence.
DicomItem addTerm(DicomItem& item, DicomTag sequence, const CodedTerm& term);

inline constexpr CodedTerm sourceImageForProcessing{"121322", "DCM", "Source image for image processing operation"};
inline constexpr CodedTerm segmentationDerivation{"113076", "DCM", "Segmentation"};

}   // namespace angiopose::io
