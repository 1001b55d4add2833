#pragma once

#include "io/dicom/dicom_dataset.h"

#include <vector>

namespace angiopose::io {

/// Frames at the R waves of the ECG, counted from 0 and ascending: those the header points to (R Wave Pointer), else
/// those nearest to the times it tells (R Wave Time Vector). What lies outside the run is left out.
std::vector<int> rWaveFramesOf(const DicomDataset& data, int frameCount, double frameTimeMs);

}   // namespace angiopose::io
