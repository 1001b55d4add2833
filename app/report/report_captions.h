#pragma once

#include "app/report/case_report.h"

namespace angiopose::app {

/// Returns whether the image of a view includes the initial pose side by side, because it differs from the view's pose.
bool showsInitialPose(const ReportedView& view);

/// Returns the HTML above the image of a view that labels its two halves; empty for a single image.
QString pairCaptions(const ReportedView& view, int widthPx);

/// Returns the HTML below the image that explains the vessel colors; empty if the colors do not represent distances.
QString colorLegend(const ReportedView& view);

}   // namespace angiopose::app
