#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Parses a number with `.` as decimal point, regardless of the locale; ignores surrounding blanks. Returns nullopt
/// unless the whole text is a number. Accepts "nan" and "inf", which callers must handle.
std::optional<double> parseNumber(std::string_view text);
std::optional<int> parseInteger(std::string_view text);

/// Returns the shortest text from which the same double can be read, with `.` in any locale.
std::string toText(double value);

std::string_view trimmed(std::string_view text);

/// Converts ASCII letters to lower case.
std::string toLower(std::string_view text);

}   // namespace angiopose::io
