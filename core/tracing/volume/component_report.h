#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"
#include "core/tracing/volume/voxels/traced_component.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// Returns all traceable connected components, largest first: those of the traced lumen with the length of their
/// branches, and those excluded earlier. Incomplete when stopped.
std::vector<TracedComponent> listComponents(const VoxelMask& lumen, const VesselTree& tree,
                                            std::vector<TracedComponent> excluded, TracingProgress& progress);

/// Returns messages about connected components: which were traced, if there are several and no seed selected them, and
/// which were not, if these contain more than one in fifty voxels.
Messages componentWarnings(const std::vector<TracedComponent>& pieces, bool isSelectedBySeeds);

}   // namespace angiopose::core
