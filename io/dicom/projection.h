#pragma once

#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

/// Whether a DICOM image is an X-ray projection: by modality, unless its SOP class has slices or its images have
/// several positions in the patient, as in reconstructed rotational angiograms.
bool isProjection(const DicomDataset& data);

}   // namespace angiopose::io
