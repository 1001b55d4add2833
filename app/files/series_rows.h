#pragma once

#include "io/dicom_series.h"
#include "ui/dialogs/series_chooser.h"

namespace angiopose::app {

/// Builds the rows of the series chooser for a folder.
std::vector<ui::SeriesRow> seriesRows(const std::vector<io::DicomSeries>& series);

}   // namespace angiopose::app
