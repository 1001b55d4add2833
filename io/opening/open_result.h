#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Result file with the folders in which to search for its inputs by name and content, including subfolders. The folder
/// of the result comes first.
struct ResultLocation {
    std::string path;   ///< result.json or joint.json
    std::vector<std::string> inputFolders;
};

/// Returns the case of a result as it was at the start of registration. Fails if an input with the recorded hash is not
/// found.
core::Result<core::Case> openInputCase(const ResultLocation& location, core::Messages& warnings,
                                       const ReadObserver& observe = {});

/// Returns the case of a result as it was at the end of registration: shows the view of the result at the registered
/// pose, with the deformed vessels, if any.
core::Result<core::Case> openResultCase(const ResultLocation& location, core::Messages& warnings,
                                        const ReadObserver& observe = {});

}   // namespace angiopose::io
