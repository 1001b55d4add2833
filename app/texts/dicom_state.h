#pragma once

#include "app/texts/dicom_objects.h"

namespace angiopose::app {

/// The overlay as vectors on the image as it is stored: vessels, measurements of the frame, and the notice.
core::Result<std::string> stateObject(const DicomGround& ground, core::Messages& notes);

}   // namespace angiopose::app
