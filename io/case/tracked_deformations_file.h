#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <cstddef>
#include <optional>
#include <string>

namespace angiopose::io {

/// Writes the deformations of a tracked cine run to `<case>.bends.nrrd` beside the case (FORMATS §2.12) and returns the
/// file with its hash. Replaces the file of an earlier save of the same case; another existing file stays, and the name
/// gets a number. `otherView`: writes `<case>.view-2.bends.nrrd` and so on for that view. The path is empty if no frame
/// is deformed.
core::Result<core::InputFile> keepFollowedDeformation(const core::FollowedRun& run, const std::string& casePath,
                                                      std::optional<std::size_t> otherView = std::nullopt);

/// Reads the points of a case's tracked deformations from their files. If a file is missing or belongs to other
/// vessels, warns and keeps only the poses.
void readDeformationOfRuns(core::Case& read, core::Messages& warnings);

}   // namespace angiopose::io
