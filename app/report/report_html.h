#pragma once

#include "app/report/report_measures.h"

#include <QString>
#include <QStringList>

namespace angiopose::app::report {

/// Returns a section heading; `extraStyle` is appended to its style.
QString heading(const QString& text, const char* extraStyle = "");

/// Returns a two-column table of names and values; `extraStyle` is appended to the style of the values.
QString table(const ReportRows& rows, const char* extraStyle = "");

/// Background color, as in the result card of the window, with the color of its text.
struct CardColors {
    const char* color;
    const char* textColor;
};
inline constexpr CardColors reliableColors{"#e3f2e6", "#14532d"};
inline constexpr CardColors unreliableColors{"#fbefd9", "#7a4a00"};

/// Returns a prominent verdict followed by sentences, on a colored background; empty if there are no sentences.
QString card(const QStringList& sentences, const CardColors& colors, const QString& verdict = {});

/// Returns two sections side by side.
QString sideBySideTable(const QString& left, const QString& right);

}   // namespace angiopose::app::report
