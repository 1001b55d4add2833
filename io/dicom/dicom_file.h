#pragma once

#include "core/support/result.h"
#include "io/dicom/element_filter.h"
#include "io/support/input_bytes.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// A parsed DICOM file. Its pixels refer to the bytes from which it was parsed or, for deflated files, to `unpacked`.
struct DicomFile {
    std::string transferSyntax;   ///< UID; empty if the file does not specify one
    DicomDataset dataset;
    std::map<DicomTag, DicomPixels> pixels;
    std::optional<core::Message> damage;   ///< problem found after the last intact element
    InputBytes unpacked;
};

/// Returns whether the content starts like a Part 10 file or a DICOM data set without a file header.
bool looksLikeDicom(std::string_view content);

/// Returns whether the content is gzip-compressed DICOM; decompresses only the beginning.
bool isGzippedDicom(std::string_view content);

/// Opens a DICOM file, which may be gzip-compressed. Fails as `openInput` does, and if the file is not DICOM.
core::Result<InputBytes> openDicom(const std::string& path);

/// Returns whether a file starts like DICOM (see `openDicom`).
bool isDicomFile(const std::string& path);

/// Parses a DICOM file: filters it with `filterElements`, then reads it through DCMTK. Fails if no element is readable.
core::Result<DicomFile> parseDicom(std::string_view content, const std::string& path);

}   // namespace angiopose::io
