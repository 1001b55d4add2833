#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/series/series.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Lists the series of all DICOM files in a folder and its subfolders, largest volume first; skips other files. Fails
/// if there is no DICOM image, or on cancellation.
core::Result<std::vector<DicomSeries>> listSeries(const std::string& folder, const ReadObserver& observe = {});

/// Returns the series to which a DICOM file belongs, built from the files of its folder.
core::Result<DicomSeries> seriesOfFile(const std::string& path, const ReadObserver& observe = {});

/// Reads the volume of a series, one slice at a time. Values are Hounsfield units for CT. Adds warnings about lost and
/// repaired data.
core::Result<core::Volume> readSeries(const DicomSeries& series, const ReadObserver& observe, core::Messages& warnings);

/// Returns the SHA-256 over the file hashes of the slices in order, which identifies a series as an input of a case.
core::Result<std::string> sha256OfSeries(const DicomSeries& series);

}   // namespace angiopose::io
