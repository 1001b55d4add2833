#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// A file that a DICOMDIR lists, with what its records say about it.
struct ListedFile {
    std::string name;   ///< below the folder of the DICOMDIR, parts joined by '/'
    core::StudyIdentity identity;
    std::string studyDescription;
    std::string seriesDescription;
    int seriesNumber = 0;
};

/// The files of a DICOMDIR (PS3.3 F.3) in the order of its tree. Fails where records are damaged, or do not lead to
/// each other: then it tells less than a look at the files.
core::Result<std::vector<ListedFile>> readDicomDirectory(const std::string& path);

/// A name as file systems of discs and DICOMDIRs may both write it: without version, in one case.
std::string comparableName(std::string name);

}   // namespace angiopose::io
