#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_item.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// What objects made of a DICOM image take over from its header, and how they refer to it.
struct SourceImage {
    struct Text {
        DicomTag tag = 0;
        const char* vr = "";
        std::string value;   ///< UTF-8
    };
    bool isDicom = false;   ///< false: of a picture or a file that cannot be read, all else is empty
    std::vector<Text> patientAndStudy;   ///< without its UID; values that the standard does not allow are empty
    std::string sopClassUid, sopInstanceUid;
    std::string studyUid, seriesUid;
    std::string frameOfReferenceUid;
    std::string modality, laterality;
    int rows = 0, columns = 0, frames = 1;
    std::vector<Text> modalityLut;   ///< rescale slope and intercept, where it has them
    std::vector<Text> lossyCompression;   ///< what was lost before, where something was
    bool isShownInverted = false;
    bool isAnnotated = false;   ///< it says that burned-in texts tell whose it is

    bool canBeReferredTo() const { return !sopClassUid.empty() && !sopInstanceUid.empty() && !seriesUid.empty(); }
    std::string patientText(DicomTag tag) const;   ///< one of `patientAndStudy`
};

/// The header of a file; pictures give an empty one. Fails where a file cannot be read.
core::Result<SourceImage> readSourceImage(const std::string& path);

SourceImage sourceImageOf(const DicomDataset& data);

/// An item that refers to an instance, in a sequence.
DicomItem addReference(DicomItem& item, DicomTag sequence, const std::string& sopClassUid,
                       const std::string& sopInstanceUid);

}   // namespace angiopose::io
