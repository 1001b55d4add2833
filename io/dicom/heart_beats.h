#pragma once

#include "io/dicom/dicom_dataset.h"

#include <vector>

namespace angiopose::io {

/// Frames at the R waves of the ECG, counted from 0 and ascending: those the header gives (R Wave Pointer), otherwise
/// those nearest to its times (R Wave Time Vector). Omits positions outside the cine run.
std::vector<int> rWaveFramesOf(const DicomDataset& data, int frameCount, double frameTimeMs);

}   // namespace angiopose::io
