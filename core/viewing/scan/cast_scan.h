#pragma once

#include "core/imaging/image2d.h"
#include "core/viewing/scan/prepared_volume.h"

#include <cmath>
#include <functional>
#include <optional>

namespace angiopose::core {

/// A picture taken from far away: all lines of sight are parallel.
struct ParallelSight {
    Eigen::Vector3d centerInPatient = Eigen::Vector3d::Zero();   ///< seen in the middle of the picture
    Eigen::Vector3d right = Eigen::Vector3d::UnitX();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    double mmPerPx = 1.0;
    int width = 0;
    int height = 0;

    Eigen::Vector3d toViewer() const { return right.cross(up); }
    /// Whether it tells where: the view of a window that cannot draw does not.
    bool isPlaced() const
    {
        return centerInPatient.allFinite() && right.allFinite() && up.allFinite() && toViewer().norm() > 0.0 &&
               std::isfinite(mmPerPx) && mmPerPx > 0.0 && width > 0 && height > 0;
    }
    bool operator==(const ParallelSight&) const = default;
};

using Rgba = std::array<std::uint8_t, 4>;

/// The scan as seen: the lowest row first, colours multiplied by their opacity. Light comes from the viewer, so that
/// surfaces show their form. `stepShare`: of the narrowest side of a voxel, from sample to sample. Of a
/// sight that is nowhere nothing is seen. No picture once `shouldContinue` says no.
std::optional<Image2d<Rgba>> castScan(const PreparedVolume& scan, const ScanLook& look, const ParallelSight& sight,
                                      double stepShare, const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core
