#pragma once

#include "app/texts/dicom_objects.h"

namespace angiopose::app {

/// Creates a presentation state with the overlay as vector graphics on the stored image: vessels, measurements of the
/// frame, and the notice.
core::Result<std::string> makePresentationState(const DicomExportInput& exportInput, core::Messages& notes);

/// Creates a secondary capture of the overlay on the shown frame.
core::Result<std::string> makeSecondaryCapture(const DicomExportInput& exportInput);

/// Creates a multi-frame secondary capture of the overlay on all frames of the cine run, each at its tracked pose, with
/// a constant display range.
core::Result<std::string> makeCineCapture(const DicomExportInput& exportInput);

}   // namespace angiopose::app
