#pragma once

#include "io/opening/loaded_inputs.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// A case with its inputs. Those that are not in their place are looked for where the hints say they lie, then by their
/// content beside the case and in `hints.searchFolders`; one that was found is named in the warnings. What is found
/// nowhere is told in `missing`, and nothing else is read.
core::Result<LoadedInputs> readCaseInputs(const std::string& path, const OpenHints& hints = {},
                                          const ReadObserver& observe = {});

/// The same for who can ask nobody: what is found nowhere is an error that names it, unless the case can do without.
core::Result<core::Case> openCase(const std::string& path, core::Messages& warnings, const ReadObserver& observe = {});

}   // namespace angiopose::io
