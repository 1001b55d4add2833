#pragma once

#include <QString>
#include <optional>
#include <string>

namespace angiopose::ui {

/// Formats a number for display, with the decimal separator of the UI language and a true minus sign. Files, tables and
/// the command line always use a decimal point.
QString numberText(double value, int decimals);

/// Formats a number with at most `digits` significant digits and without trailing zeros, e.g. "0,01" or "1000".
QString briefNumber(double value, int digits);

/// Parses a number typed with a decimal comma or point, in any language; nullopt if the text is not a number.
std::optional<double> numberFrom(QString typed);

/// Replaces the decimal separator by that of the UI language in text that contains only numbers, units and angles ("LAO
/// 30.0", "0.31 mm/px"); leaves other text unchanged, since it may be a name.
QString withDecimalSign(const QString& text);

/// Formats a local time: "14:32" today, "21 Nov 14:32" otherwise; empty if there is none.
QString shortTime(const std::string& isoTime);

}   // namespace angiopose::ui
