#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// CSV of how every point of the tree moved (FORMATS §3.5): a centreline table of the unbent tree with the motion
/// (mm, patient LPS) and 1-σ of its place in the image plane and along the ray; no rows where `bent` is of another
/// tree. Written atomically.
core::Status writeMotion(const core::VesselTree& tree, const core::DeformableResult& deformed, const std::string& path);

}   // namespace angiopose::io
