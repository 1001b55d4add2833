#pragma once

#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Skull of a head CT, used to distinguish arteries from veins: dural venous sinuses run along the inner table;
/// arteries enter from the neck and run to the middle of the head.
class Skull {
public:
    /// Returns whether a vessel of the given radius lies next to bone at the level of the skull vault.
    bool isNextToInnerTable(const Eigen::Vector3d& pointInPatient, double radiusMm) const;

    /// Returns the position in the axial plane between the middle of the head (0) and the bone (1); nullopt if no bone
    /// ring surrounds the point.
    std::optional<double> radialPosition(const Eigen::Vector3d& pointInPatient) const;

    /// Length of a vessel centerline within the skull vault, and of its part next to the inner table, in mm.
    struct Course {
        double withinMm = 0.0;
        double adjacentMm = 0.0;
    };
    Course courseOf(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& radiusMm) const;

    friend std::optional<Skull> findSkull(const VolumeGeometry& grid, const VoxelOpacification& fill, int threads,
                                          TracingProgress& progress);

private:
    /// Bone ring in one slice.
    struct Ring {
        bool isClosed = false;
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();   ///< in blocks
        std::vector<double> radius;   ///< in blocks, by direction
    };

    const Ring* ringAt(const Eigen::Vector3d& block) const;

    DistanceMap toBone_;   ///< distance to bone, on the grid of blocks
    std::vector<Ring> rings_;   ///< one ring per slice of blocks
    Eigen::Affine3d blockFromPatient_;
};

/// Finds the skull; nullopt if bone does not enclose soft tissue over 20 mm along the body (no head, only its middle,
/// or no CT). Values of `fill` (patient axis order) above 1.5 are bone, below -1 air. Incomplete when stopped.
std::optional<Skull> findSkull(const VolumeGeometry& grid, const VoxelOpacification& fill, int threads,
                               TracingProgress& progress);

/// Returns the centerline points of the great vessels that are dural venous sinuses.
std::vector<Eigen::Vector3d> sinusPoints(const std::vector<GreatVessel>& great, const Skull& skull);

/// Returns only definite arteries of the head: vessels that enter from the neck and do not run along the skull like
/// venous sinuses. If the sinuses enhance like the arteries, a vessel must also reach the middle of the head.
std::vector<GreatVessel> selectHeadArteries(std::vector<GreatVessel> great, const Skull& skull,
                                            const VolumeGeometry& grid);

}   // namespace angiopose::core
