#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/case/moved_inputs.h"
#include "io/support/read_observer.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// The JSON Schema of `*.angiopose` files, as published under resources/.
const std::string& caseSchema();

/// Reads a case file and the inputs it names (FORMATS §2). Relative paths are relative to the case file.
/// An input whose content no longer matches its stored hash loads with a warning. Vessels given as a volume, a
/// segmentation or a surface are traced: `observe` shows the progress and can stop it. Inputs in `moved` are read from
/// there instead.
core::Result<core::Case> loadCase(const std::string& path, core::Messages& warnings, const ReadObserver& observe = {},
                                  const MovedInputs& moved = {});

/// Schema and meaning only, without loading the inputs: every problem found, empty when the case is fine.
core::Result<core::Messages> validateCase(const std::string& path);

/// What in a case's geometry is missing or makes no sense together with the header of its image, which is read.
/// Nothing of it keeps the case from loading. Fails where the case or the image cannot be read.
core::Result<core::Messages> doubtsOfCase(const std::string& path);

/// What the case lacks to be written as a file that opens again.
std::optional<core::Message> findUnsavable(const core::Case& session);

/// Writes atomically (temporary file, flush, rename); paths relative to the case file, hashes of the inputs,
/// keys unknown to this version kept.
core::Status saveCase(const core::Case& session, const std::string& path);

}   // namespace angiopose::io