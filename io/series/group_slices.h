#pragma once

#include "io/series/series.h"

#include <vector>

namespace angiopose::io {

/// Groups the images of many files into volumes and X-ray runs by series, size, spacing and orientation. Separates
/// images at the same position by acquisition, phase, echo or recording order, and removes true duplicates.
std::vector<DicomSeries> groupSlices(std::vector<DicomImages> files);

}   // namespace angiopose::io
