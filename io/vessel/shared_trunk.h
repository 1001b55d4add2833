#pragma once

#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::io {

/// VMTK writes one line per outlet, each starting at the inlet: the trunk is there once per outlet. Returns pieces that
/// cover every vessel once, cut at the bifurcations; lines that share nothing come back as they are, ids included.
/// Two lines share a stretch when they stay closer than 0.1 mm for 3 mm or more.
std::vector<core::VesselBranch> withoutSharedTrunks(const std::vector<core::VesselBranch>& lines);

}   // namespace angiopose::io