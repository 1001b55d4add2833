#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Result file, and the folders in which to search for its inputs by name and content, including subfolders. The folder
/// of the result comes first.
struct ResultLocation {
    std::string path;   ///< result.json or joint.json
    std::vector<std::string> inputFolders;
};

/// Restores from a result the case at the start of the registration. Fails if an input with the recorded content is not
/// found.
core::Result<core::Case> openInputCase(const ResultLocation& place, core::Messages& warnings,
                                       const ReadObserver& observe = {});

/// Restores from a result the case at the end of the registration: shows the view of the result at the registered pose,
/// with the deformed vessels, if any.
core::Result<core::Case> openResultCase(const ResultLocation& place, core::Messages& warnings,
                                        const ReadObserver& observe = {});

}   // namespace angiopose::io
