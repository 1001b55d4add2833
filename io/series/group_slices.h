#pragma once

#include "io/series/series.h"

#include <vector>

namespace angiopose::io {

/// Groups the images of many files into volumes and X-ray runs: by series, size, spacing and orientation; images at the
/// same place are told apart by acquisition, phase, echo, or order of recording; true duplicates are dropped.
std::vector<DicomSeries> groupSlices(std::vector<DicomImages> files);

}   // namespace angiopose::io