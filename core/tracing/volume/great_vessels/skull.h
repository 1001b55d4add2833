#pragma once

#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Skull of a head in CT, used to distinguish arteries from veins: sinuses run along its inner table, arteries come
/// from the neck and run to the middle of the head.
class Skull {
public:
    /// Whether a vessel of that radius at the given point lies next to bone, at the height of the vault.
    bool isBesideTable(const Eigen::Vector3d& inPatient, double radiusMm) const;

    /// Position between the middle of the head (0) and its bone (1) in the axial plane; nothing if no bone ring
    /// surrounds the point.
    std::optional<double> outwardShare(const Eigen::Vector3d& inPatient) const;

    /// Length in mm along the axis within the vault, and the part of it next to the inner table.
    struct Course {
        double withinMm = 0.0;
        double besideMm = 0.0;
    };
    Course courseOf(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& radiusMm) const;

    friend std::optional<Skull> findSkull(const VolumeGeometry& grid, const VoxelFill& fill, int threads,
                                          TracingProgress& progress);

private:
    /// Bone ring in one slice.
    struct Ring {
        bool isClosed = false;
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();   ///< in blocks
        std::vector<double> radius;   ///< in blocks, by direction
    };

    const Ring* ringAt(const Eigen::Vector3d& block) const;

    DistanceMap toBone_;   ///< distance to bone, in blocks of some mm
    std::vector<Ring> rings_;   ///< by slice of blocks
    Eigen::Affine3d blockFromPatient_;
};

/// Finds the skull; nothing if bone does not enclose soft tissue over 20 mm along the body (no head, only its middle,
/// or no CT). `fill` (patient axis order) above 1.5 is bone, below -1 air. Incomplete when stopped.
std::optional<Skull> findSkull(const VolumeGeometry& grid, const VoxelFill& fill, int threads,
                               TracingProgress& progress);

/// Axis points of the great vessels that are sinuses.
std::vector<Eigen::Vector3d> sinusPlaces(const std::vector<GreatVessel>& great, const Skull& skull);

/// Keeps the great vessels that are definitely arteries of the head: those along the skull are sinuses, and if sinuses
/// are opacified as much as arteries, a vessel from the neck must also run to the middle of the head.
std::vector<GreatVessel> arteriesOfHead(std::vector<GreatVessel> great, const Skull& skull, const VolumeGeometry& grid);

}   // namespace angiopose::core
