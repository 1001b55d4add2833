#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// A scan below ../shared/data; empty, with the reason on stdout, where it cannot be read.
core::Volume readScan(const std::string& relative);

/// The thoracic CTA with the arteries that its masks give.
struct ThoracicScan {
    core::Volume scan;
    core::LabelVolume arteries;   ///< 0 elsewhere
    core::VoxelMask lumens;   ///< the same with the masks of the torn aorta's two lumens
    core::VesselTree axes;   ///< of the arteries
    core::DistanceMap toArteries;   ///< 0 in them

    Eigen::Vector3d at(int i, int j, int k) const;   ///< LPS mm of a voxel
    bool isArtery(const Eigen::Vector3d& inPatient) const;
    bool isLumen(const Eigen::Vector3d& inPatient) const;
    bool isAtAnEnd(const Eigen::Vector3d& inPatient) const;   ///< of an artery's mask
    double value(const Eigen::Vector3d& inPatient) const;   ///< of the scan, HU
    double mmToArteries(const Eigen::Vector3d& inPatient) const;
};

std::optional<ThoracicScan> readThoracicScan();

/// Click into the ascending aorta, and where its tree begins.
Eigen::Vector3d seedOf(const ThoracicScan& thorax);
Eigen::Vector3d rootOf(const ThoracicScan& thorax);

/// Places at least 3 voxels within the aorta, drawn with a seed.
std::vector<Eigen::Vector3d> placesInAorta(const ThoracicScan& thorax, int count);

}   // namespace angiopose::benchmarks