#pragma once

#include "app/report/report_captions.h"

#include <QDateTime>
#include <QString>

// What a report tells of one view, part by part, each under its heading; empty where there is nothing to tell.
namespace angiopose::app::report {

/// ISO 8601 with the time zone: read alike everywhere.
QString timeWords(const QDateTime& time);

/// Whether the pose is to be trusted, what that means, and what the program says of it.
QString verdictPart(const ReportedView& view);

/// How near the vessels lie, and how the pose came about.
QString resultPart(const ReportedView& view);

QString branchPart(const ReportedView& view);
QString measuredPart(const core::Case& session);
QString checkedPart(const core::Case& session);
QString geometryPart(const core::Case& session);
QString posePart(const core::Case& session);

}   // namespace angiopose::app::report
