#pragma once

#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// `Vessels`: a scan, segmentation or surface that is traced; `Folder`: DICOM files to choose from; `Pose`: where a
/// case has its vessels, with or without a camera; `Points`: fiducials.
enum class InputKind { Case, Centerline, Vessels, Folder, Image, Target, Pose, Points };

/// What a file claims to be, judged by its first bytes and, where these do not tell, by its name.
/// Fails naming the file when it cannot be read or is nothing that the program opens.
core::Result<InputKind> inputKindOf(const std::string& path);

}   // namespace angiopose::io
