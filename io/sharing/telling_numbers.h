#pragma once

#include <string>
#include <string_view>

namespace angiopose::io {

/// `text` with "[uid]" and "[date]" in place of UIDs and of dates in any usual form.
std::string withoutTellingNumbers(std::string_view text);

}   // namespace angiopose::io
