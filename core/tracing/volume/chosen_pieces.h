#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace core {

/// Leaves of a mask what is asked for: the pieces that hold the seeds (LPS mm, within 3 mm), or without seeds the
/// largest. Returns a warning about what was left out, empty when nothing worth it was; fails, naming it, for a seed
/// that lies in no piece, and for an empty mask.
Result<std::string> keepChosenPieces(VoxelMask& mask, const std::vector<Eigen::Vector3d>& seedsInPatient);

}   // namespace core
