#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>

namespace angiopose::io {

/// The one rigid transform of an HDF5 file of ITK (`.h5`; several in a composite become one), read by ITK.
core::Result<core::RigidTransform> poseFromItkHdf5(const std::string& path, const ReadObserver& observe = {});

/// Writes the same as an affine transform, every double as it is.
core::Status writeItkHdf5(const core::RigidTransform& cameraFromPatient, const std::string& path);

}   // namespace angiopose::io
