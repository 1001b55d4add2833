#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// A number written with `.` in any locale, surrounding blanks allowed; nothing unless all of `text` is the number.
/// "nan" and "inf" are numbers here: the caller decides what they mean.
std::optional<double> parseNumber(std::string_view text);
std::optional<int> parseInteger(std::string_view text);

/// The shortest text that restores the same double, with `.` in any locale.
std::string toText(double value);

std::string_view trimmed(std::string_view text);

/// ASCII letters in lower case, all else as it is.
std::string lowered(std::string_view text);

}   // namespace angiopose::io