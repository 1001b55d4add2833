#pragma once

#include "app/report/report_measures.h"

#include <QString>
#include <QStringList>

namespace angiopose::app::report {

/// A heading of a part, with more style after its own.
QString heading(const QString& text, const char* moreStyle = "");

/// Two columns: what it is, what it is here, with more style of the latter.
QString table(const ReportRows& rows, const char* moreStyle = "");

/// A ground of its own, as the window's card has it, and the ink that is read on it.
struct Ground {
    const char* color;
    const char* ink;
};
inline constexpr Ground certainGround{"#e3f2e6", "#14532d"};
inline constexpr Ground doubtfulGround{"#fbefd9", "#7a4a00"};

/// Sentences on a ground, after a word that is seen first; nothing where there are none.
QString card(const QStringList& sentences, const Ground& ground, const QString& verdict = {});

/// Two columns of parts.
QString beside(const QString& left, const QString& right);

}   // namespace angiopose::app::report
