#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_item.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Header data that derived objects copy from a DICOM image, and the identifiers with which they reference the image.
struct SourceImage {
    struct Text {
        DicomTag tag = 0;
        const char* vr = "";
        std::string value;   ///< value of the element, UTF-8
    };
    bool isDicom = false;   ///< false if the file is unreadable or not DICOM; all other members are then empty
    std::vector<Text> patientAndStudy;   ///< excludes the study UID; empty where the standard forbids the value
    std::string sopClassUid, sopInstanceUid;
    std::string studyUid, seriesUid;
    std::string frameOfReferenceUid;
    std::string modality, laterality;
    int rows = 0, columns = 0, frames = 1;
    std::vector<Text> modalityLut;   ///< rescale slope and intercept, if present
    std::vector<Text> lossyCompression;   ///< lossy compression history, if any
    bool isShownInverted = false;
    bool declaresBurnedInText = false;   ///< whether the header declares burned-in text that identifies the patient

    bool isReferenceable() const { return !sopClassUid.empty() && !sopInstanceUid.empty() && !seriesUid.empty(); }
    std::string patientText(DicomTag tag) const;   ///< returns the value of one element of `patientAndStudy`
};

/// Reads the header of a file; the result is empty if the file is not DICOM. Fails if the file cannot be read.
core::Result<SourceImage> readSourceImage(const std::string& path);

SourceImage sourceImageOf(const DicomDataset& data);

/// Adds an item to `sequence` that references an instance.
DicomItem addReference(DicomItem& item, DicomTag sequence, const std::string& sopClassUid,
                       const std::string& sopInstanceUid);

}   // namespace angiopose::io
