#pragma once

#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::io {

/// Removes repeated trunks: VMTK writes one line per outlet, each starting at the inlet, so that the trunk is repeated
/// for every outlet. Returns pieces that cover every vessel once, cut at the bifurcations; lines that share nothing are
/// returned unchanged, with their ids. Two lines share a stretch if they stay closer than 0.1 mm for 3 mm or more.
std::vector<core::VesselBranch> splitSharedTrunks(const std::vector<core::VesselBranch>& lines);

}   // namespace angiopose::io
