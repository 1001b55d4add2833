#pragma once

#include "core/case/view.h"
#include "core/support/result.h"

#include <cstddef>
#include <optional>
#include <string>

namespace angiopose::io {

/// Writes a case's edited 2-D curves to `<case>.curves.csv` next to the case, unless up to date, and returns the file
/// with its hash. Overwrites the file that an earlier save of the same case created; if another file of that name
/// exists, appends a number to the name. If `otherView` is set, the file is `<case>.view-2.curves.csv` and so on.
core::Result<core::InputFile> saveEditedCurves(const core::GivenTarget& target, const std::string& casePath,
                                               std::optional<std::size_t> otherView = std::nullopt);

/// Returns the source file of a target as named in exports. For edited curves, saved or not, the name is empty and the
/// hash is that of the file that would be saved.
core::InputFile exportedFile(const core::GivenTarget& target);

}   // namespace angiopose::io
