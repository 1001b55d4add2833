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

/// A series, volume or run that can be opened, or is listed with the reason why it cannot.
struct StudySeries {
    DicomSeries series;
    SeriesUse use = SeriesUse::None;
    std::optional<core::Message> reason;   ///< reason why it cannot be used here
    std::string bodyPart;
    int imageCount = 0;   ///< slices of a volume, frames of a run, files of any other series
    double frameTimeMs = 0.0;   ///< 0: unknown
    /// Path to open: for a volume the deepest folder that holds its whole series, for a run its file.
    std::string place;
    std::size_t missingFiles = 0;   ///< files that the DICOMDIR lists and that do not exist
};

struct Study {
    core::StudyIdentity identity;   ///< identity from one of its files
    std::string description;
    std::vector<StudySeries> series;   ///< sorted by number
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
    std::optional<core::Message> damage;   ///< reason why it is unusable; the files were searched instead
    std::size_t series = 0;   ///< series that it lists
    std::size_t files = 0;
    std::size_t missingFiles = 0;
    std::size_t unlistedFiles = 0;   ///< possible images not listed, unread
};

/// The content of a folder or disc.
struct StudyTree {
    std::vector<StudyPatient> patients;   ///< sorted by name
    std::size_t foundFiles = 0;
    std::size_t readFiles = 0;
    std::size_t otherFiles = 0;   ///< files that are not DICOM
    std::vector<DamagedFile> damaged;   ///< including files read in part
    std::optional<DirectoryCheck> directory;
    bool isStopped = false;   ///< stopped by the user: the list may be incomplete
    bool isCutOff = false;   ///< the folder has more files than could be listed
};

}   // namespace angiopose::io
