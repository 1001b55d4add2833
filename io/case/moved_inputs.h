#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// An input that does not exist at the path stored in its case.
struct MissingInput {
    std::string path;   ///< absolute path stored in the case
    std::string sha256;   ///< hash of the original content; empty if unknown
    bool isOptional = false;   ///< true if the case opens without it: an additional scan, or another view

    bool operator==(const MissingInput&) const = default;
};

/// New locations of inputs, keyed by their paths in the case.
using MovedInputs = std::map<std::string, std::string>;

/// Returns the inputs of a case file that do not exist. Fails like loadCase if the file is not a case.
core::Result<std::vector<MissingInput>> findMissingInputs(const std::string& casePath);

/// Searches folders and their subfolders for inputs, first by name, then by content among the files with the same
/// extension. A known hash must match; without a hash, the name decides. Finds a folder (a DICOM series) by its name.
/// Stops searching a folder after some thousand entries. Can be canceled.
MovedInputs findMovedInputs(const std::vector<MissingInput>& missing, const std::vector<std::string>& folders,
                            const ReadObserver& observe = {});

/// Returns whether a file or folder can replace a missing input. The contents must match unless the hash is unknown.
bool canReplace(const MissingInput& missing, const std::string& path);

}   // namespace angiopose::io
