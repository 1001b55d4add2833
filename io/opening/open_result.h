#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// The result file and the folders, searched with their subfolders, for its inputs by name and content. The folder of
/// the result comes first.
struct ResultPlace {
    std::string path;   ///< result.json or joint.json
    std::vector<std::string> inputFolders;
};

/// Restores the case at the start of the registration from its result. Fails if an input with the recorded content is
/// not found.
core::Result<core::Case> openAsked(const ResultPlace& place, core::Messages& warnings,
                                   const ReadObserver& observe = {});

/// Restores the case at the end of the registration: shows the view of the result at the registered pose, with deformed
/// vessels if there are any.
core::Result<core::Case> openFound(const ResultPlace& place, core::Messages& warnings,
                                   const ReadObserver& observe = {});

}   // namespace angiopose::io
