#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// An input that is not where its case says.
struct MissingInput {
    std::string path;   ///< absolute, as the case has it
    std::string sha256;   ///< of the content it had; empty: not known
    bool isOptional = false;   ///< the case opens without it: a scan beside the vessels, another view

    bool operator==(const MissingInput&) const = default;
};

/// Where inputs lie now, by the path that the case has for them.
using MovedInputs = std::map<std::string, std::string>;

/// The inputs of a case file that are not there. Fails as loadCase when the file is no case.
core::Result<std::vector<MissingInput>> missingInputs(const std::string& casePath);

/// Looks for inputs in folders and their sub-folders, first under their name, then under any name with the same
/// extension. Where the content's hash is known only the same content counts; without a hash the name decides. A folder
/// (a DICOM series) is found by its name. Gives up a folder after some thousand entries. Stops when asked.
MovedInputs findMovedInputs(const std::vector<MissingInput>& missing, const std::vector<std::string>& folders,
                            const ReadObserver& observe = {});

/// Whether a file or folder can stand for a missing input: the same content, or where that is not known, anything.
bool isFeasibleFor(const MissingInput& missing, const std::string& path);

}   // namespace angiopose::io