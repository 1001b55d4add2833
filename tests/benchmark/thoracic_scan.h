#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/distance_map.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace benchmarks {

/// A scan below ../shared/data; empty, with the reason on stdout, where it cannot be read.
core::Volume readScan(const std::string& relative);

/// The thoracic CTA with the arteries that its masks give.
struct ThoracicScan {
    core::Volume scan;
    core::LabelVolume arteries;   ///< 0 elsewhere
    core::VesselTree axes;   ///< of the arteries
    core::DistanceMap toArteries;   ///< 0 in them

    Eigen::Vector3d at(int i, int j, int k) const;   ///< LPS mm of a voxel
    bool isArtery(const Eigen::Vector3d& inPatient) const;
    double value(const Eigen::Vector3d& inPatient) const;   ///< of the scan, HU
    double mmToArteries(const Eigen::Vector3d& inPatient) const;
};

std::optional<ThoracicScan> readThoracicScan();

/// Click into the ascending aorta, and where its tree begins.
Eigen::Vector3d seedOf(const ThoracicScan& thorax);
Eigen::Vector3d rootOf(const ThoracicScan& thorax);

/// Places at least 3 voxels within the aorta, drawn with a seed.
std::vector<Eigen::Vector3d> placesInAorta(const ThoracicScan& thorax, int count);

/// A stretch of a branch outside the masks.
struct OutsideRun {
    int branch = 0;
    double lengthMm = 0.0;
    double radiusMm = 0.0;   ///< median, as are the values
    double value = 0.0;
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    double farthestMm = 0.0;   ///< from the masks
    bool isArterial = false;   ///< as bright as the masked arteries are: a vessel that the masks leave out
};

/// Where traced curves run; shares of their length.
struct Course {
    double lengthMm = 0.0;
    double inside = 0.0;   ///< within the masks
    double outsideArterial = 0.0;
    double outsideOther = 0.0;
    double covered = 0.0;   ///< share of the masks' axes beside which a curve runs within the masks
    std::vector<OutsideRun> outside;
};

/// Axes outside `seen` (if given) do not count as to be covered.
Course courseOf(const core::VesselTree& tree, const ThoracicScan& thorax, const core::VolumeGeometry* seen = nullptr);

}   // namespace benchmarks
