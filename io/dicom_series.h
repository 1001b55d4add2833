#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/series/slice_record.h"
#include "io/series/slice_stack.h"
#include "io/support/read_observer.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// One thing to open in a DICOM folder: the slices of a volume, or an X-ray run.
struct DicomSeries {
    std::string id;   ///< Series Instance UID, with "#2", … for further volumes of the same series
    core::StudyIdentity identity;
    std::string description;
    int number = 0;   ///< Series Number
    std::optional<core::Message> part;   ///< what tells it from other volumes of its series, e.g. "part 2 of 10"
    bool isAngiogram = false;   ///< a projection; `slices.front().path` is the run
    std::vector<SliceRecord> slices;   ///< ordered along the normal of their planes
    SliceStack stack;   ///< of a volume
    core::Messages warnings;   ///< missing slices, tilt, uneven spacing, duplicates, …
    std::optional<core::Message> problem;   ///< why it cannot be opened
};

/// Series of all DICOM files in a folder and below it, largest volume first; other files are passed over. Fails when
/// there is no DICOM image at all, or when stopped.
core::Result<std::vector<DicomSeries>> listSeries(const std::string& folder, const ReadObserver& observe = {});

/// The series of one DICOM file among the files of its folder.
core::Result<DicomSeries> seriesOfFile(const std::string& path, const ReadObserver& observe = {});

/// The volume of a series, slices decoded one after the other into place. Values are Hounsfield units for CT.
/// What was lost or mended is added to `warnings`.
core::Result<core::Volume> readSeries(const DicomSeries& series, const ReadObserver& observe, core::Messages& warnings);

/// SHA-256 over the hashes of the slices' files in their order: the identity of a series as an input of a case.
core::Result<std::string> sha256OfSeries(const DicomSeries& series);

}   // namespace angiopose::io