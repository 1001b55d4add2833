#pragma once

#include "app/report/case_report.h"

namespace angiopose::app {

/// Whether the image of a view includes the initial pose next to it: the view has one and its pose differs.
bool showsInitialPose(const ReportedView& view);

/// Returns the HTML above the image of a view that names its two halves; empty for a single image.
QString pairCaptions(const ReportedView& view, int widthPx);

/// Returns the HTML below the image that explains the vessel colors; empty if the colors do not show distances.
QString colorLegend(const ReportedView& view);

}   // namespace angiopose::app
