#pragma once

#include "core/case/case.h"

#include <string>

namespace angiopose::io {

/// What a case is made of, as "key: value" in lines: kinds, sizes, counts, options that are not as usual, what the
/// verdicts say by their ids. Nothing that was typed, no name, date, path or UID.
std::string caseSummary(const core::Case& theCase);

}   // namespace angiopose::io
