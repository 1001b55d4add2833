#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <cstddef>
#include <optional>
#include <string>

namespace angiopose::io {

/// Writes the deformations of a tracked cine run to `<case>.bends.nrrd` next to the case (FORMATS §2.12) and returns
/// the file with its hash. Overwrites the file that an earlier save of the same case created; if another file of that
/// name exists, appends a number to the name. If `otherView` is set, the file is `<case>.view-2.bends.nrrd` and so on.
/// The returned path is empty if no frame is deformed.
core::Result<core::InputFile> saveTrackedDeformations(const core::TrackedRun& run, const std::string& casePath,
                                                      std::optional<std::size_t> otherView = std::nullopt);

/// Reads the points of a case's tracked deformations from their files. If a file is missing or belongs to other
/// vessels, warns and keeps only the poses.
void readTrackedDeformations(core::Case& read, core::Messages& warnings);

}   // namespace angiopose::io
