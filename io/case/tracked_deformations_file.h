#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <cstddef>
#include <optional>
#include <string>

namespace angiopose::io {

/// The file of how the vessels are bent in the frames of a followed run, with its hash: each case has its own,
/// `<case>.bends.nrrd` beside it (FORMATS §2.12). The file of an earlier save of the same case is replaced, any other
/// of that name is left alone and a number added to the name. `otherView`: for the run of that view of the case,
/// `<case>.view-2.bends.nrrd` and on. No path where no frame is bent.
core::Result<core::InputFile> keepFollowedDeformation(const core::FollowedRun& run, const std::string& casePath,
                                                      std::optional<std::size_t> otherView = std::nullopt);

/// The bends of a case as its file tells them get their points from those files. Where one cannot be had, or is not of
/// these vessels, its run keeps the poses and goes without bends, and a warning says so.
void readDeformationOfRuns(core::Case& read, core::Messages& warnings);

}   // namespace angiopose::io
