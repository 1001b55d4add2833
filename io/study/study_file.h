#pragma once

#include "core/support/result.h"
#include "io/series/slice_record.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// Header data of one DICOM file, for a list of studies.
struct StudyFile {
    std::string path;
    DicomImages images;   ///< images of the file; `damage` is set if the file is truncated
    std::string studyDescription;
    std::string bodyPart;
    std::string imageType;   ///< image type, for example "ORIGINAL\PRIMARY\LOCALIZER"
    std::string transferSyntax;
    int frames = 1;
    int samples = 1;   ///< samples per pixel: 1 (grayscale) or 3 (color)
    double frameTimeMs = 0.0;
};

/// Reads a file up to its pixels. Returns nullopt if it is not DICOM; fails if it is DICOM but cannot be read.
core::Result<std::optional<StudyFile>> readStudyFile(const std::string& path);

}   // namespace angiopose::io
