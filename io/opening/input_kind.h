#pragma once

#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// `Vessels`: a scan, segmentation or surface to be traced; `Folder`: DICOM files to choose from; `Pose`: position of
/// the vessels in a case, with or without a camera; `Points`: fiducials.
enum class InputKind { Case, Centerline, Vessels, Folder, Image, Target, Pose, Points };

/// Determines the kind of a file by its first bytes and, if these are ambiguous, by its name. Fails, naming the file,
/// if it cannot be read or has an unsupported type.
core::Result<InputKind> inputKindOf(const std::string& path);

}   // namespace angiopose::io
