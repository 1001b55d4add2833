#pragma once

#include "core/simulation/scan_painter.h"
#include "core/support/random.h"
#include "tests/support/bodies/simulate_any_scan.h"

namespace angiopose::core {

/// What is drawn for one scan before anything is painted.
struct ScanDraw {
    double voxelMm = 0.8;
    double sliceMm = 4.0;   ///< of thick slices
    double bloodHu = 400.0;
    double noise = 25.0;   ///< in HU; MR takes the same share of its own contrast
    double fallOff = 3.0;
    double scale = 1.0;   ///< of the whole patient
    bool isMirrored = false;
};

/// A box of the patient, mm.
struct ScanBox {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
};

ScanDraw drawScan(ScanRanges ranges, CounterRandom& random);

VolumeGeometry gridOf(const ScanBox& box, const Eigen::Vector3d& spacingMm);

/// Scans of heads and of trunks; `volume` is as drawn, `great` not yet set.
AnyScan drawHead(ScanKind kind, const ScanDraw& draw, CounterRandom& random);
AnyScan drawTrunk(ScanKind kind, const ScanDraw& draw, CounterRandom& random);

/// Adds what `shares` of the voxels hold, of a value by place.
template <class ValueAt>
void blendTree(ScanPainter& painter, const VesselTree& tree, const ValueAt& valueAt)
{
    ScanGrid shares(painter.geometry(), 0.0F);
    ScanPainter sharePainter(shares);
    paintTree(sharePainter, tree, painter.geometry(), 1.0);
    for (std::size_t voxel = 0; voxel < shares.voxels.size(); ++voxel) {
        if (shares.voxels[voxel] > 0.0F) {
            painter.blend(voxel, shares.voxels[voxel], valueAt(voxel));
        }
    }
}

}   // namespace angiopose::core
