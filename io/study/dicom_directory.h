#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// A file listed in a DICOMDIR, with the values of its records.
struct ListedFile {
    std::string name;   ///< relative to the folder of the DICOMDIR, parts joined by '/'
    core::StudyIdentity identity;
    std::string studyDescription;
    std::string seriesDescription;
    int seriesNumber = 0;
};

/// Returns the files of a DICOMDIR (PS3.3 F.3) in the order of its tree. Fails if records are damaged or not linked
/// consistently; reading the files then gives more information.
core::Result<std::vector<ListedFile>> readDicomDirectory(const std::string& path);

/// Normalizes a name so that names on a disc's file system and in its DICOMDIR compare equal: without version, in one
/// letter case.
std::string comparableName(std::string name);

}   // namespace angiopose::io
