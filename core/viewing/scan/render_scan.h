#pragma once

#include "core/imaging/image2d.h"
#include "core/viewing/scan/prepared_volume.h"

#include <cmath>
#include <functional>
#include <optional>

namespace angiopose::core {

/// A parallel projection of the scan.
struct ParallelProjection {
    Eigen::Vector3d centerInPatient = Eigen::Vector3d::Zero();   ///< point in the center of the image
    Eigen::Vector3d right = Eigen::Vector3d::UnitX();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    double mmPerPx = 1.0;
    int width = 0;
    int height = 0;

    Eigen::Vector3d toViewer() const { return right.cross(up); }
    /// Whether the projection is defined; false while a window cannot draw.
    bool isDefined() const
    {
        return centerInPatient.allFinite() && right.allFinite() && up.allFinite() && toViewer().norm() > 0.0 &&
               std::isfinite(mmPerPx) && mmPerPx > 0.0 && width > 0 && height > 0;
    }
    bool operator==(const ParallelProjection&) const = default;
};

using Rgba = std::array<std::uint8_t, 4>;

/// Renders the scan with a headlight that shades the surfaces. The image has its bottom row first and colors
/// premultiplied by opacity; it is empty if `isDefined` is false. `stepFraction` is the sampling distance as a fraction
/// of the shortest voxel side. Returns nullopt if `shouldContinue` returns false.
std::optional<Image2d<Rgba>> renderScan(const PreparedVolume& scan, const ScanAppearance& appearance,
                                        const ParallelProjection& projection, double stepFraction,
                                        const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core
