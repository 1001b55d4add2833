#pragma once

#include "core/case/view.h"
#include "core/support/result.h"

#include <cstddef>
#include <optional>
#include <string>

namespace angiopose::io {

/// The file of a case's edited 2-D curves, with its hash: each case has its own, `<case>.curves.csv` beside it.
/// Written unless it is there already; the file of an earlier save of the same case is replaced, any other of that name
/// is left alone and a number added to the name. `otherView`: for the edited curves of that view of the case,
/// `<case>.view-2.curves.csv` and on.
core::Result<core::InputFile> keepEditedCurves(const core::GivenTarget& target, const std::string& casePath,
                                               std::optional<std::size_t> otherView = std::nullopt);

/// The file a target comes from, as exports name it. Edited curves have no name, saved or not, and the hash of what
/// would be saved.
core::InputFile exportedFileOf(const core::GivenTarget& target);

}   // namespace angiopose::io