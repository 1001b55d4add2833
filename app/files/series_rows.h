#pragma once

#include "io/dicom_series.h"
#include "ui/dialogs/series_chooser.h"

namespace angiopose::app {

/// The series of a folder in the words of the chooser.
std::vector<ui::SeriesRow> seriesRows(const std::vector<io::DicomSeries>& series);

}   // namespace angiopose::app