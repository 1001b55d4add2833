#pragma once

#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

/// Whether a DICOM image is an X-ray projection: by modality, unless its SOP class is one of slices, or its images lie
/// at several places in the patient, as those of a reconstructed rotational angiogram do.
bool isProjection(const DicomDataset& data);

}   // namespace angiopose::io
