#pragma once

#include <QString>
#include <optional>
#include <string>

namespace angiopose::ui {

/// Formats numbers for display with the decimal separator of the language and a true minus sign. Files, tables and the
/// command line always use a point.
QString numberText(double value, int decimals);

/// Formats with at most `digits` significant digits, without trailing zeros: "0,01", "1000".
QString briefNumber(double value, int digits);

/// Parses input with comma or point in any language; empty if it is not a number.
std::optional<double> numberFrom(QString typed);

/// Localizes the decimal separator of texts that contain only numbers, units and angles ("LAO 30.0", "0.31 mm/px");
/// leaves other texts unchanged, since they may be names.
QString withDecimalSign(const QString& text);

/// Formats a local time: "14:32" today, "21 Nov 14:32" otherwise; empty without a time.
QString shortTime(const std::string& isoTime);

}   // namespace angiopose::ui
