#pragma once

#include "app/report/report_captions.h"

#include <QDateTime>
#include <QString>

// Sections of a report on one view, each with its heading. A section is empty if there is nothing to report.
namespace angiopose::app::report {

/// Formats the time in ISO 8601 with the time zone, independent of the locale.
QString timestampText(const QDateTime& time);

/// Returns whether the pose is reliable and what that means, with the warnings of the registration.
QString verdictSection(const ReportedView& view);

/// Returns the residuals of the pose and its origin.
QString resultSection(const ReportedView& view);

QString branchSection(const ReportedView& view);
QString measurementSection(const core::Case& session);
QString targetPointSection(const core::Case& session);
QString geometrySection(const core::Case& session);
QString poseSection(const core::Case& session);

}   // namespace angiopose::app::report
