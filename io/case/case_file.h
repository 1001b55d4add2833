#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/case/moved_inputs.h"
#include "io/support/read_observer.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the JSON Schema of `*.angiopose` files, as published in resources/.
const std::string& caseSchema();

/// Reads a case file and the inputs it names (FORMATS §2). Relative paths are relative to the case file. Warns if an
/// input no longer matches its stored hash. Traces the vessels if the input is a volume, a segmentation or a surface;
/// `observe` receives the progress and can cancel. Reads inputs in `moved` from their new location.
core::Result<core::Case> loadCase(const std::string& path, core::Messages& warnings, const ReadObserver& observe = {},
                                  const MovedInputs& moved = {});

/// Validates schema and values without loading the inputs. Returns all problems; empty if the case is valid.
core::Result<core::Messages> validateCase(const std::string& path);

/// Checks a case's geometry against the header of its image. Returns warnings about missing or implausible values,
/// none of which prevents loading. Fails if the case or the image cannot be read.
core::Result<core::Messages> checkCaseGeometry(const std::string& path);

/// Explains why the case cannot be saved to a file that can be opened again; returns nullopt if it can.
std::optional<core::Message> findSaveObstacle(const core::Case& session);

/// Writes the case atomically (temporary file, flush, rename), with paths relative to the case file, hashes of the
/// inputs and keys unknown to this version.
core::Status saveCase(const core::Case& session, const std::string& path);

}   // namespace angiopose::io
