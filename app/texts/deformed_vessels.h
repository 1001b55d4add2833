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

/// Returns the deformation of a view that can be drawn with the vessels at `pose`: it was computed from that pose and
/// for this tree, and is visible. Otherwise null.
std::shared_ptr<const core::DeformableResult> deformationForPose(const core::View& view, const core::Vessels& vessels,
                                                                 const core::RigidTransform& pose);

/// Distance of each point of the deformed tree from the rigid tree, both as drawn, with the maximum of the color scale.
struct DisplacementMap {
    std::map<int, std::vector<double>>
        distanceMm;   ///< by branch id; perpendicular to the ray if determined from one view, otherwise in 3-D
    double largestMm = 0.0;
    double scaleMaximumMm = 0.0;
};

/// Vessels of a view as drawn at a pose.
struct DrawnVessels {
    std::shared_ptr<const core::DeformableResult> known;   ///< see deformationForPose
    VesselShape shape = VesselShape::Rigid;   ///< `Deformed` only if a deformation is known
    std::optional<int> otherFrame;   ///< frame in which the deformation was determined, if another frame is shown
    core::VesselTree tree;   ///< all branches, in patient coordinates at that pose
    DisplacementMap motion;   ///< displacement map of `known`
};
DrawnVessels drawnVessels(const core::View& view, const core::Vessels& vessels, const core::RigidTransform& pose,
                          VesselShape wanted);

/// Returns the captions on the vessel shape: deformed and by how much, or rigid, and that a single view does not
/// determine the depth. Empty if no deformation is known.
core::Messages shapeLines(const DrawnVessels& drawn);

/// Returns the heading of the color scale of a displacement map.
core::Message motionHeading();

}   // namespace angiopose::app
