#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Fails if the file is too short for its voxels or the voxels do not fit into memory; does not read any voxels.
core::Status checkVoxels(const StoredVolume& stored);

/// Reads the voxels of a stored volume as 16 bits, directly into place. Types of up to 16 bits, and whole numbers that
/// span at most 16 bits, keep every value; others are rounded to 65535 steps, with a warning that states the step.
core::Result<core::Volume> readVoxels(const StoredVolume& stored, const ReadObserver& observe,
                                      core::Messages& warnings);

/// Reads the voxels of a stored label image; fails if a value is not a label (fractional, negative, or above 65535).
core::Result<core::LabelVolume> readLabelVoxels(const StoredVolume& stored, const ReadObserver& observe);

}   // namespace angiopose::io
