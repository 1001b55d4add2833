#pragma once

#include "app/report/report_captions.h"

#include <QDateTime>
#include <QString>

// Sections of a report on one view, each with its heading; empty if there is nothing to report.
namespace angiopose::app::report {

/// ISO 8601 with time zone, independent of the locale.
QString timeWords(const QDateTime& time);

/// Whether the pose is reliable, what that means, and the program's warnings.
QString verdictPart(const ReportedView& view);

/// Residuals and origin of the pose.
QString resultPart(const ReportedView& view);

QString branchPart(const ReportedView& view);
QString measuredPart(const core::Case& session);
QString checkedPart(const core::Case& session);
QString geometryPart(const core::Case& session);
QString posePart(const core::Case& session);

}   // namespace angiopose::app::report
