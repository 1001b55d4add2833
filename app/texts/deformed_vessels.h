#pragma once

#include "core/case/case.h"
#include "core/support/message.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::app {

/// Shape of the vessels on an image: rigid as placed by the pose, or deformed if a deformation is known.
enum class VesselShape { Rigid, Deformed };

/// Returns the deformation of a view if it can be drawn with the vessels at `pose`, that is, if it was computed from
/// that pose and for this tree and is visible; otherwise null.
std::shared_ptr<const core::DeformableResult> deformationForPose(const core::View& view, const core::Vessels& vessels,
                                                                 const core::RigidTransform& pose);

/// Distance of each point of the deformed tree from the rigid tree, both as drawn, with the maximum of the color scale.
struct DisplacementMap {
    std::map<int, std::vector<double>>
        distanceMm;   ///< distances by branch ID; perpendicular to the ray if from one view, otherwise in 3-D
    double maxMm = 0.0;
    double scaleMaximumMm = 0.0;
};

/// Vessels of a view as drawn at a pose.
struct DrawnVessels {
    std::shared_ptr<const core::DeformableResult> known;   ///< deformation that can be drawn; see deformationForPose
    VesselShape shape = VesselShape::Rigid;   ///< `Deformed` only if a deformation is known
    std::optional<int> otherFrame;   ///< frame in which the deformation was determined, if another frame is shown
    core::VesselTree tree;   ///< all branches, in patient coordinates at that pose
    DisplacementMap motion;   ///< displacement map of `known`
};
DrawnVessels vesselsToDraw(const core::View& view, const core::Vessels& vessels, const core::RigidTransform& pose,
                           VesselShape preferredShape);

/// Returns captions about the vessel shape: whether the vessels are deformed, and by how much, or rigid, and that a
/// single view does not determine depth. Empty if no deformation is known.
core::Messages shapeLines(const DrawnVessels& drawn);

/// Returns the heading of the color scale of a displacement map.
core::Message motionHeading();

}   // namespace angiopose::app
