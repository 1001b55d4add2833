#pragma once

#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// The skull of a head in a CT, as far as it tells its arteries from its veins: sinuses run along its inner table,
/// arteries come from the neck and run to its middle.
class Skull {
public:
    /// Whether a place with a vessel of that radius around it lies beside bone, at the height of the vault.
    bool isBesideTable(const Eigen::Vector3d& inPatient, double radiusMm) const;

    /// From the middle of the head (0) to its bone (1), across the body; nothing where no bone closes around the place.
    std::optional<double> outwardShare(const Eigen::Vector3d& inPatient) const;

    /// mm along the axis within the vault, and of that beside its table.
    struct Course {
        double withinMm = 0.0;
        double besideMm = 0.0;
    };
    Course courseOf(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& radiusMm) const;

    friend std::optional<Skull> findSkull(const VolumeGeometry& grid, const VoxelFill& fill, int threads,
                                          TracingProgress& progress);

private:
    /// Bone around the middle of one slice.
    struct Ring {
        bool isClosed = false;
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();   ///< in blocks
        std::vector<double> radius;   ///< in blocks, by direction
    };

    const Ring* ringAt(const Eigen::Vector3d& block) const;

    DistanceMap toBone_;   ///< in blocks of some mm
    std::vector<Ring> rings_;   ///< by slice of blocks
    Eigen::Affine3d blockFromPatient_;
};

/// None where bone does not close around soft tissue over 20 mm along the body: no head, only its middle, or no CT.
/// What `fill` (patient axis order) has above 1.5 is bone, below -1 air. Incomplete when stopped.
std::optional<Skull> findSkull(const VolumeGeometry& grid, const VoxelFill& fill, int threads,
                               TracingProgress& progress);

/// Points on the axes of those that are sinuses.
std::vector<Eigen::Vector3d> sinusPlaces(const std::vector<GreatVessel>& great, const Skull& skull);

/// Leaves the great vessels that are arteries of the head for sure: those along the skull are sinuses, and where these
/// are filled as well as arteries, what comes from the neck must run to the middle of the head.
std::vector<GreatVessel> arteriesOfHead(std::vector<GreatVessel> great, const Skull& skull, const VolumeGeometry& grid);

}   // namespace angiopose::core
