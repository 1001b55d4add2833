#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_gate.h"
#include "io/support/input_bytes.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// A parsed DICOM file. Its pixels refer to the bytes it was parsed from, or to `unpacked` for deflated files.
struct DicomFile {
    std::string transferSyntax;   ///< UID; "" if the file does not give one
    DicomDataset dataset;
    std::map<DicomTag, DicomPixels> pixels;
    std::optional<core::Message> damage;   ///< the problem after the last intact element
    InputBytes unpacked;
};

/// True for a part-10 file, and for a bare data set that begins like one.
bool looksLikeDicom(std::string_view content);

/// True for a gzip archive whose content begins like DICOM; decompresses only the beginning.
bool holdsPackedDicom(std::string_view content);

/// Opens a DICOM file, also inside a gzip archive. Fails like `openInput`, and if the content is not DICOM.
core::Result<InputBytes> openDicom(const std::string& path);

/// True for files that begin like DICOM, see `openDicom`.
bool isDicomFile(const std::string& path);

/// Parses a DICOM file: filters it by `passElements`, then reads it through DCMTK. Fails if no element is readable.
core::Result<DicomFile> parseDicom(std::string_view content, const std::string& path);

}   // namespace angiopose::io