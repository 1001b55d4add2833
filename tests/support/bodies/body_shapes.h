#pragma once

#include "core/simulation/scan_painter.h"

#include <vector>

namespace angiopose::core {

/// An ellipsoid in any direction.
struct TurnedEllipsoid {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();   ///< columns: unit directions
    Eigen::Vector3d halfAxesMm = Eigen::Vector3d::Ones();

    /// About how far outside a place is, mm; negative inside.
    double distanceMm(const Eigen::Vector3d& place) const
    {
        const Eigen::Vector3d share = (axes.transpose() * (place - center)).cwiseQuotient(halfAxesMm);
        return (share.norm() - 1.0) * halfAxesMm.minCoeff();
    }
};

void paintEllipsoid(ScanPainter& painter, const TurnedEllipsoid& shape, double hu);

/// What lies in the first but outside the second.
void paintDifference(ScanPainter& painter, const TurnedEllipsoid& shape, const TurnedEllipsoid& without, double hu);

/// A branch through points, its radius changing evenly from the first to the last; without generation and id.
VesselBranch taperedBranch(std::vector<Eigen::Vector3d> points, double firstRadiusMm, double lastRadiusMm);

/// Adds a branch with the next id.
void addBranch(VesselTree& tree, VesselBranch branch, int generation);

}   // namespace angiopose::core
