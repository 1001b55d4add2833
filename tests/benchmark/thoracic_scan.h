#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Reads a scan below ../shared/data. If that fails, prints the reason to stdout and returns an empty volume.
core::Volume readScan(const std::string& relative);

/// The thoracic CTA with the arteries from its masks.
struct ThoracicScan {
    core::Volume scan;
    core::LabelVolume arteries;   ///< labels; 0 outside
    core::VoxelMask lumens;   ///< the arteries plus the masks of the dissected aorta's two lumens
    core::VesselTree axes;   ///< centerlines of the arteries
    core::DistanceMap toArteries;   ///< distance to the arteries, 0 inside

    Eigen::Vector3d at(int i, int j, int k) const;   ///< position of a voxel, LPS mm
    bool isArtery(const Eigen::Vector3d& inPatient) const;
    bool isLumen(const Eigen::Vector3d& inPatient) const;
    bool isAtAnEnd(const Eigen::Vector3d& inPatient) const;   ///< at the end of an artery's mask
    double value(const Eigen::Vector3d& inPatient) const;   ///< scan value, HU
    double mmToArteries(const Eigen::Vector3d& inPatient) const;
};

std::optional<ThoracicScan> readThoracicScan();

/// Seed in the ascending aorta, where its tree begins.
Eigen::Vector3d seedOf(const ThoracicScan& thorax);
Eigen::Vector3d rootOf(const ThoracicScan& thorax);

/// Random points at least 3 voxels inside the aorta, reproducible by a fixed seed.
std::vector<Eigen::Vector3d> placesInAorta(const ThoracicScan& thorax, int count);

}   // namespace angiopose::benchmarks
