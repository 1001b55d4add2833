#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Fails when the file is too short for its voxels, or they do not fit in memory; reads none of them.
core::Status checkVoxels(const StoredVolume& stored);

/// Voxels of a stored volume as 16 bit, read straight into their place. Types of up to 16 bit, and whole numbers that
/// span no more than 16 bit, keep every value; others are rounded to 65535 steps, with a warning that says how large.
core::Result<core::Volume> readVoxels(const StoredVolume& stored, const ReadObserver& observe,
                                      core::Messages& warnings);

/// Voxels of a stored label image; fails on values that are no labels (fractions, negative, above 65535).
core::Result<core::LabelVolume> readLabelVoxels(const StoredVolume& stored, const ReadObserver& observe);

}   // namespace angiopose::io