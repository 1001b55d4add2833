#pragma once

#include "core/simulation/scan_painter.h"

#include <vector>

namespace angiopose::core {

/// An ellipsoid in any orientation.
struct TurnedEllipsoid {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();   ///< columns are unit directions
    Eigen::Vector3d halfAxesMm = Eigen::Vector3d::Ones();

    /// Approximate signed distance of a point from the surface, mm; negative inside.
    double distanceMm(const Eigen::Vector3d& place) const
    {
        const Eigen::Vector3d share = (axes.transpose() * (place - center)).cwiseQuotient(halfAxesMm);
        return (share.norm() - 1.0) * halfAxesMm.minCoeff();
    }
};

void paintEllipsoid(ScanPainter& painter, const TurnedEllipsoid& shape, double hu);

/// Paints the region inside the first shape but outside the second.
void paintDifference(ScanPainter& painter, const TurnedEllipsoid& shape, const TurnedEllipsoid& without, double hu);

/// A branch through the points, with a radius that changes linearly from the first to the last; without generation and
/// id.
VesselBranch taperedBranch(std::vector<Eigen::Vector3d> points, double firstRadiusMm, double lastRadiusMm);

/// Adds a branch with the next id.
void addBranch(VesselTree& tree, VesselBranch branch, int generation);

}   // namespace angiopose::core
