#pragma once

#include <QString>
#include <optional>
#include <string>

namespace angiopose::ui {

/// How the window writes numbers: with the decimal sign of its language, and a minus. Files, tables and the command
/// line keep the point whatever the window speaks.
QString numberText(double value, int decimals);

/// With so many significant digits and no more than needed: "0,01", "1000".
QString briefNumber(double value, int digits);

/// What was typed, with comma or point, whichever the language has; nothing where that is no number.
std::optional<double> numberFrom(QString typed);

/// Words that are numbers, units and angles alone ("LAO 30.0", "0.31 mm/px") with the language's decimal sign; any
/// other as it is, since it may be a name.
QString withDecimalSign(const QString& text);

/// "14:32" today, "21 Nov 14:32" otherwise, in local time; empty for no time.
QString shortTime(const std::string& isoTime);

}   // namespace angiopose::ui
