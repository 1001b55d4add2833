#pragma once

#include "app/texts/dicom_objects.h"

namespace angiopose::app {

/// The overlay as vectors on the image as it is stored: vessels, measurements of the frame, and the notice.
core::Result<std::string> stateObject(const DicomGround& ground, core::Messages& notes);

/// The overlay of the shown frame as a secondary capture.
core::Result<std::string> pictureObject(const DicomGround& ground);

/// The overlay through the run, each frame at the pose that following found, in grey values that stay the same.
core::Result<std::string> runObject(const DicomGround& ground);

}   // namespace angiopose::app
