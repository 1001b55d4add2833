#include "core/tracing/volume/path/path_end.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/voxels/chosen_pieces.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double snapReachMm = 2.0;

}   // namespace

Result<PathEnd> pathEnd(const PathGround& ground, const Eigen::Vector3d& placeInPatient)
{
    const VolumeGeometry& grid = ground.volume().geometry;
    const Eigen::Vector3i clicked = (grid.patientFromVoxel().inverse() * placeInPatient).array().round().cast<int>();
    if (!placeInPatient.allFinite() || !grid.contains(clicked)) {
        return Error(messages::pathEndOutsideScan(placeInMessage(placeInPatient)));
    }
    PathEnd end;
    end.voxel = ground.likeliestNear(clicked, std::max(snapReachMm, grid.spacingMm.minCoeff()));
    end.look = ground.lookAt(end.voxel);
    if (end.look.blood <= end.look.tissue) {
        return Error(messages::pathEndInNothing(placeInMessage(placeInPatient)));
    }
    return end;
}

}   // namespace angiopose::core
