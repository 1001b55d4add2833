#pragma once

#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// `Vessels`: scan, segmentation or surface to be traced; `Folder`: DICOM files to choose from; `Pose`: a pose of the
/// vessels, with or without a camera; `Points`: fiducials.
enum class InputKind { Case, Centerline, Vessels, Folder, Image, Target, Pose, Points };

/// Determines the kind of a file from its first bytes and, if these are ambiguous, from its name. If the file cannot be
/// read or its type is unsupported, fails and names the file.
core::Result<InputKind> inputKindOf(const std::string& path);

}   // namespace angiopose::io
