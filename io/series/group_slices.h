#pragma once

#include "io/series/series.h"

#include <vector>

namespace angiopose::io {

/// Groups the images of many files into volumes and X-ray runs by series, size, spacing and orientation. Images at the
/// same position are separated by acquisition, phase, echo or recording order; true duplicates are removed.
std::vector<DicomSeries> groupSlices(std::vector<DicomImages> files);

}   // namespace angiopose::io
