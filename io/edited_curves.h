#pragma once

#include "core/case/view.h"
#include "core/support/result.h"

#include <cstddef>
#include <optional>
#include <string>

namespace angiopose::io {

/// Writes a case's edited 2-D curves to `<case>.curves.csv` beside it, unless already there, and returns the file with
/// its hash. Replaces the file of an earlier save of the same case; another existing file stays, and the name gets a
/// number. `otherView`: writes `<case>.view-2.curves.csv` and so on for that view.
core::Result<core::InputFile> keepEditedCurves(const core::GivenTarget& target, const std::string& casePath,
                                               std::optional<std::size_t> otherView = std::nullopt);

/// Returns the source file of a target as named in exports. For edited curves, saved or not, the name is empty and the
/// hash is that of the content that would be saved.
core::InputFile exportedFileOf(const core::GivenTarget& target);

}   // namespace angiopose::io
