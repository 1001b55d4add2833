#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"
#include "io/series/series.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// What a series can be in a case.
enum class SeriesUse { Vessels, View, None };

/// One thing that can be opened, or that is there and cannot.
struct StudySeries {
    DicomSeries series;
    SeriesUse use = SeriesUse::None;
    std::optional<core::Message> reason;   ///< why it is of no use here
    std::string bodyPart;
    int imageCount = 0;   ///< slices of a volume, frames of a run, files of anything else
    double frameTimeMs = 0.0;   ///< 0: not known
    /// From where it opens: of a volume the deepest folder that holds its whole series, of a run its file.
    std::string place;
    std::size_t missingFiles = 0;   ///< that the DICOMDIR lists and that are not there
};

struct Study {
    core::StudyIdentity identity;   ///< of one of its files
    std::string description;
    std::vector<StudySeries> series;   ///< by number
};

struct StudyPatient {
    core::StudyIdentity identity;
    std::vector<Study> studies;   ///< newest first
};

struct DamagedFile {
    std::string path;
    core::Message reason;
};

/// What a DICOMDIR said, checked against the files beside it.
struct DirectoryCheck {
    std::optional<core::Message> damage;   ///< it was of no use: the files were looked through
    std::size_t series = 0;   ///< that it lists
    std::size_t files = 0;
    std::size_t missingFiles = 0;
    std::size_t unlistedFiles = 0;   ///< that may be images, unread
};

/// What lies in a folder or on a disc.
struct StudyTree {
    std::vector<StudyPatient> patients;   ///< by name
    std::size_t foundFiles = 0;
    std::size_t readFiles = 0;
    std::size_t otherFiles = 0;   ///< no DICOM
    std::vector<DamagedFile> damaged;   ///< among them some that were read in part
    std::optional<DirectoryCheck> directory;
    bool isStopped = false;   ///< there may be more
    bool isCutOff = false;   ///< of the folder not all could be listed
};

}   // namespace angiopose::io
