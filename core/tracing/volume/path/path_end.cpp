#include "core/tracing/volume/path/path_end.h"

#include "core/messages/messages.h"
#include "core/tracing/volume/voxels/component_selection.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double snapReachMm = 2.0;

}   // namespace

Result<PathEnd> findPathEnd(const TubeDetector& detector, const Eigen::Vector3d& positionInPatient)
{
    const VolumeGeometry& grid = detector.volume().geometry;
    const Eigen::Vector3i clicked = (grid.patientFromVoxel().inverse() * positionInPatient).array().round().cast<int>();
    if (!positionInPatient.allFinite() || !grid.contains(clicked)) {
        return Error(messages::pathEndOutsideScan(formatPoint(positionInPatient)));
    }
    PathEnd end;
    end.voxel = detector.bestVoxelNear(clicked, std::max(snapReachMm, grid.spacingMm.minCoeff()));
    end.appearance = detector.appearanceAt(end.voxel);
    if (end.appearance.blood <= end.appearance.tissue) {
        return Error(messages::pathEndOutsideVessel(formatPoint(positionInPatient)));
    }
    return end;
}

}   // namespace angiopose::core
