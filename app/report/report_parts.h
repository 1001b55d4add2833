#pragma once

#include "app/report/report_captions.h"

#include <QDateTime>
#include <QString>

// Sections of a report on one view, each with its heading. A section is empty if it has nothing to report.
namespace angiopose::app::report {

/// Formats the time in ISO 8601 with the time zone, independent of the locale.
QString timeWords(const QDateTime& time);

/// Returns whether the pose is reliable, what that means, and the warnings of the registration.
QString verdictPart(const ReportedView& view);

/// Returns the residuals and the origin of the pose.
QString resultPart(const ReportedView& view);

QString branchPart(const ReportedView& view);
QString measuredPart(const core::Case& session);
QString checkedPart(const core::Case& session);
QString geometryPart(const core::Case& session);
QString posePart(const core::Case& session);

}   // namespace angiopose::app::report
