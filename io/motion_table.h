#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Atomically writes a CSV with the displacement of every point of the tree (FORMATS §3.5): a centerline table of the
/// undeformed tree with the displacement (mm, patient LPS) and its 1-σ uncertainty in-plane and in depth. Writes no
/// rows if `deformed` belongs to another tree.
core::Status writeMotion(const core::VesselTree& tree, const core::DeformableResult& deformed, const std::string& path);

}   // namespace angiopose::io
