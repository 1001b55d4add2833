#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_gate.h"
#include "io/support/input_bytes.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// A parsed DICOM file. Pixels point into the bytes it was parsed from, or into `unpacked` for deflated files.
struct DicomFile {
    std::string transferSyntax;   ///< UID; "" when the file does not say
    DicomDataset dataset;
    std::map<DicomTag, DicomPixels> pixels;
    std::optional<core::Message> damage;   ///< what is wrong after the last good element
    InputBytes unpacked;
};

/// True for a part-10 file, and for a bare data set that starts like one.
bool looksLikeDicom(std::string_view content);

/// True for a gzip archive whose content begins like DICOM: no more of it is unpacked to know.
bool holdsPackedDicom(std::string_view content);

/// Opens a DICOM file, also one inside a gzip archive. Fails as `openInput` does, and on content that is not DICOM.
core::Result<InputBytes> openDicom(const std::string& path);

/// True for what begins as `openDicom` wants it.
bool isDicomFile(const std::string& path);

/// Passes the gate first, then DCMTK. Fails when there is no element that can be read.
core::Result<DicomFile> parseDicom(std::string_view content, const std::string& path);

}   // namespace angiopose::io