#pragma once

#include "io/opening/loaded_inputs.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Reads a case with its inputs. Searches for missing inputs first where the hints place them, then by content in the
/// case's folder and in `hints.searchFolders`; a warning names each input found elsewhere. `missing` lists those not
/// found, and nothing else is then read.
core::Result<LoadedInputs> readCaseInputs(const std::string& path, const OpenHints& hints = {},
                                          const ReadObserver& observe = {});

/// Opens a case without user interaction: a missing input is an error that names it, unless the case can do without.
core::Result<core::Case> openCase(const std::string& path, core::Messages& warnings, const ReadObserver& observe = {});

}   // namespace angiopose::io
