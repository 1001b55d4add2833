#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"
#include "io/series/series.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// The role that a series can have in a case.
enum class SeriesUse { Vessels, View, None };

/// Series, volume or run that can be opened, or that is listed with the reason why it cannot be opened.
struct StudySeries {
    DicomSeries series;
    SeriesUse use = SeriesUse::None;
    std::optional<core::Message> reason;   ///< reason why the series cannot be used in a case
    std::string bodyPart;
    int imageCount = 0;   ///< number of slices of a volume, frames of a run, or files of any other series
    double frameTimeMs = 0.0;   ///< frame interval, ms; 0 if unknown
    /// Path to open: the deepest folder that contains the whole series of a volume, or the file of a run.
    std::string place;
    std::size_t missingFiles = 0;   ///< number of files listed in the DICOMDIR that do not exist
};

struct Study {
    core::StudyIdentity identity;   ///< identity as read from one of the files
    std::string description;
    std::vector<StudySeries> series;   ///< sorted by series number
};

struct StudyPatient {
    core::StudyIdentity identity;
    std::vector<Study> studies;   ///< newest first
};

struct DamagedFile {
    std::string path;
    core::Message reason;
};

/// Comparison of a DICOMDIR with the files on the disc.
struct DirectoryCheck {
    std::optional<core::Message> damage;   ///< reason why the DICOMDIR is unusable; the files were searched instead
    std::size_t series = 0;   ///< number of series listed in the DICOMDIR
    std::size_t files = 0;
    std::size_t missingFiles = 0;
    std::size_t unlistedFiles = 0;   ///< number of files that are not listed but may be images; these were not read
};

/// The contents of a folder or disc.
struct StudyTree {
    std::vector<StudyPatient> patients;   ///< sorted by name
    std::size_t foundFiles = 0;
    std::size_t readFiles = 0;
    std::size_t otherFiles = 0;   ///< number of files that are not DICOM
    std::vector<DamagedFile> damagedFiles;   ///< damaged files, including those that were read in part
    std::optional<DirectoryCheck> directory;
    bool isStopped = false;   ///< whether the user canceled, in which case the list may be incomplete
    bool isTruncated = false;   ///< whether the folder contains more files than the maximum
};

}   // namespace angiopose::io
