#pragma once

#include "core/imaging/image2d.h"
#include "core/viewing/scan/prepared_volume.h"

#include <cmath>
#include <functional>
#include <optional>

namespace angiopose::core {

/// A parallel projection: all lines of sight are parallel.
struct ParallelSight {
    Eigen::Vector3d centerInPatient = Eigen::Vector3d::Zero();   ///< shown in the center of the image
    Eigen::Vector3d right = Eigen::Vector3d::UnitX();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    double mmPerPx = 1.0;
    int width = 0;
    int height = 0;

    Eigen::Vector3d toViewer() const { return right.cross(up); }
    /// Whether it defines a position; the view of a window that cannot draw does not.
    bool isPlaced() const
    {
        return centerInPatient.allFinite() && right.allFinite() && up.allFinite() && toViewer().norm() > 0.0 &&
               std::isfinite(mmPerPx) && mmPerPx > 0.0 && width > 0 && height > 0;
    }
    bool operator==(const ParallelSight&) const = default;
};

using Rgba = std::array<std::uint8_t, 4>;

/// Renders the scan: bottom row first, colors premultiplied by opacity. A headlight shades the surfaces. `stepShare` is
/// the sampling step as a fraction of the shortest voxel side. Empty for a sight without a position. Returns nothing if
/// `shouldContinue` returns false.
std::optional<Image2d<Rgba>> castScan(const PreparedVolume& scan, const ScanLook& look, const ParallelSight& sight,
                                      double stepShare, const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core
