#pragma once

#include "core/imaging/angiogram.h"
#include "io/series/slice_record.h"
#include "io/series/slice_stack.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Part of a DICOM folder that can be opened: the slices of a volume, or an X-ray run.
struct DicomSeries {
    std::string id;   ///< Series Instance UID, with the suffix "#2", … for further volumes of the same series
    core::StudyIdentity identity;
    std::string description;
    int number = 0;   ///< Series Number
    std::optional<core::Message> part;   ///< distinguishes the volume from others of its series, e.g. "part 2 of 10"
    bool isAngiogram = false;   ///< whether this is an X-ray run; `slices.front().path` is then its file
    std::vector<SliceRecord> slices;   ///< slices sorted along the slice normal
    SliceStack stack;   ///< set for volumes only
    core::Messages warnings;   ///< warnings about missing slices, gantry tilt, uneven spacing, duplicates, …
    std::optional<core::Message> problem;   ///< reason why the series cannot be opened
};

}   // namespace angiopose::io
