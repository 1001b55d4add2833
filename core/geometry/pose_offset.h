#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

namespace angiopose::core {

/// A pose change in radiographic terms, relative to a reference pose and about a pivot (the tree's centroid). The
/// shifts move the pivot in screen directions; the angles rotate the vessels about the pivot, in camera axes.
struct PoseOffset {
    double rightMm = 0.0;   ///< to the right on screen
    double upMm = 0.0;   ///< up on screen
    double alongRayMm = 0.0;   ///< away from the source, along the camera axis
    double rollDeg = 0.0;   ///< clockwise on screen
    double laoRaoDeg = 0.0;   ///< as if the C-arm rotated to LAO (+) or RAO (−): about the screen's vertical axis
    double craCauDeg = 0.0;   ///< as if the C-arm angulated to CRA (+) or CAU (−): about the screen's horizontal axis

    bool operator==(const PoseOffset&) const = default;
};

/// Applies `offset` to `reference` and returns the new pose. Only the shifts move the pivot (patient frame, mm).
RigidTransform applyOffset(const RigidTransform& reference, const PoseOffset& offset,
                           const Eigen::Vector3d& pivotInPatient, const ProjectionCamera& camera);

/// Returns the offset from `reference` to `pose`; exact inverse of applyOffset for |laoRao| < 90°.
PoseOffset offsetBetween(const RigidTransform& reference, const RigidTransform& pose,
                         const Eigen::Vector3d& pivotInPatient, const ProjectionCamera& camera);

}   // namespace angiopose::core
