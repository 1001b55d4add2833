#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// A file listed in a DICOMDIR, with the values of its records.
struct DirectoryEntry {
    std::string name;   ///< path relative to the folder of the DICOMDIR, with components joined by '/'
    core::StudyIdentity identity;
    std::string studyDescription;
    std::string seriesDescription;
    int seriesNumber = 0;
};

/// Returns the files of a DICOMDIR (PS3.3 F.3) in the order of its record tree. Fails if records are damaged or linked
/// inconsistently; the caller should then read the files themselves.
core::Result<std::vector<DirectoryEntry>> readDicomDirectory(const std::string& path);

/// Normalizes a file name so that names in the file system of a disc and in its DICOMDIR compare equal: removes the
/// version suffix and unifies the letter case.
std::string normalizedFileName(std::string name);

}   // namespace angiopose::io
