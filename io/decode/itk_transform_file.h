#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <string>

namespace angiopose::io {

/// Reads the single rigid transform of an ITK HDF5 file (`.h5`) through ITK; combines the transforms of a composite.
core::Result<core::RigidTransform> poseFromItkHdf5(const std::string& path, const ReadObserver& observe = {});

/// Writes the pose as an affine transform with full double precision.
core::Status writeItkHdf5(const core::RigidTransform& cameraFromPatient, const std::string& path);

}   // namespace angiopose::io
