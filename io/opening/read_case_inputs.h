#pragma once

#include "io/opening/loaded_inputs.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Reads a case with its inputs. Looks for missing inputs first at the locations in the hints, then by content in the
/// case's folder and in `hints.searchFolders`; a warning names each input found elsewhere. If inputs are not found,
/// lists them in `missing` and reads nothing else.
core::Result<LoadedInputs> readCaseInputs(const std::string& path, const OpenHints& hints = {},
                                          const ReadObserver& observe = {});

/// Opens a case without user interaction. Fails and names the input if a required one is missing.
core::Result<core::Case> openCase(const std::string& path, core::Messages& warnings, const ReadObserver& observe = {});

}   // namespace angiopose::io
