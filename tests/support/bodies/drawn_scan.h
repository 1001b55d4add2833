#pragma once

#include "core/simulation/scan_painter.h"
#include "core/support/random.h"
#include "tests/support/bodies/simulate_any_scan.h"

namespace angiopose::core {

/// Random parameters of one scan, drawn before anything is painted.
struct ScanDraw {
    double voxelMm = 0.8;
    double sliceMm = 4.0;   ///< thickness of thick slices
    double bloodHu = 400.0;
    double noise = 25.0;   ///< in HU; in MR the same share of its own contrast
    double fallOff = 3.0;
    double scale = 1.0;   ///< scale of the whole patient
    bool isMirrored = false;
};

/// A box in patient coordinates, mm.
struct ScanBox {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
};

ScanDraw drawScan(ScanRanges ranges, CounterRandom& random);

VolumeGeometry gridOf(const ScanBox& box, const Eigen::Vector3d& spacingMm);

/// Draws scans of heads and of trunks; `volume` is as drawn, `great` is not set yet.
AnyScan drawHead(ScanKind kind, const ScanDraw& draw, CounterRandom& random);
AnyScan drawTrunk(ScanKind kind, const ScanDraw& draw, CounterRandom& random);

/// Blends a tree into the painted scan with a value that depends on the voxel.
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
