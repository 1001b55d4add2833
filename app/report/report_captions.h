#pragma once

#include "app/report/case_report.h"

namespace angiopose::app {

/// Whether the picture of a view has the start pose beside it: where there is one, and the view is at another.
bool hasStartBeside(const ReportedView& view);

/// HTML above the picture of a view: what its two halves are; nothing above a single one.
QString captionsOf(const ReportedView& view, int widthPx);

/// HTML below it: what the colours of the vessels mean; nothing where they tell no distance.
QString colorLineOf(const ReportedView& view);

}   // namespace angiopose::app
