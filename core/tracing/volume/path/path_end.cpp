#include "core/tracing/volume/path/path_end.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/voxels/component_selection.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double snapReachMm = 2.0;

}   // namespace

Result<PathEnd> findPathEnd(const TubeDetector& ground, const Eigen::Vector3d& positionInPatient)
{
    const VolumeGeometry& grid = ground.volume().geometry;
    const Eigen::Vector3i clicked = (grid.patientFromVoxel().inverse() * positionInPatient).array().round().cast<int>();
    if (!positionInPatient.allFinite() || !grid.contains(clicked)) {
        return Error(messages::pathEndOutsideScan(formatPoint(positionInPatient)));
    }
    PathEnd end;
    end.voxel = ground.bestVoxelNear(clicked, std::max(snapReachMm, grid.spacingMm.minCoeff()));
    end.look = ground.appearanceAt(end.voxel);
    if (end.look.blood <= end.look.tissue) {
        return Error(messages::pathEndOutsideVessel(formatPoint(positionInPatient)));
    }
    return end;
}

}   // namespace angiopose::core
