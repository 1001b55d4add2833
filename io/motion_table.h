#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Writes a CSV of the motion of every point of the tree (FORMATS §3.5): a centerline table of the undeformed tree with
/// the motion (mm, patient LPS) and the 1-σ uncertainty of its position in the image plane and along the ray. No rows
/// if `deformed` belongs to another tree. Written atomically.
core::Status writeMotion(const core::VesselTree& tree, const core::DeformableResult& deformed, const std::string& path);

}   // namespace angiopose::io
