#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Where the inputs of a result are looked for: by name and content, in folders and those below them. Its own folder
/// comes first.
struct ResultPlace {
    std::string path;   ///< result.json or joint.json
    std::vector<std::string> inputFolders;
};

/// The case as the registration began with it, from what its result tells. Fails where an input is not there with the
/// content that it had.
core::Result<core::Case> openAsked(const ResultPlace& place, core::Messages& warnings,
                                   const ReadObserver& observe = {});

/// The same case as the registration left it: the view of the result is shown, at the pose that was found, with bent
/// vessels where there are any.
core::Result<core::Case> openFound(const ResultPlace& place, core::Messages& warnings,
                                   const ReadObserver& observe = {});

}   // namespace angiopose::io
