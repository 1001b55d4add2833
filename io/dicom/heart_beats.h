#pragma once

#include "io/dicom/dicom_dataset.h"

#include <vector>

namespace angiopose::io {

/// Returns the indices of the frames at the R waves of the ECG, in ascending order: those in the header (R Wave
/// Pointer), otherwise the frames nearest to the R-wave times (R Wave Time Vector). Omits R waves outside the cine run.
std::vector<int> rWaveFramesOf(const DicomDataset& data, int frameCount, double frameTimeMs);

}   // namespace angiopose::io
