#pragma once

#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

/// Returns whether a DICOM image is an X-ray projection. The modality decides, unless the images of the SOP class are
/// slices or the frames have several positions in the patient, as in reconstructed rotational angiograms.
bool isProjection(const DicomDataset& data);

}   // namespace angiopose::io
