#pragma once

#include "core/case/case.h"
#include "core/support/message.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::app {

/// Shape of the vessels on an image: as placed by the rigid pose, or deformed if a deformation was found.
enum class VesselShape { Rigid, Deformed };

/// Deformation of a view that can be drawn with the vessels at `pose`: it was found from that pose and for this tree,
/// and is visible. Else null.
std::shared_ptr<const core::DeformableResult> drawableDeformation(const core::View& view, const core::Vessels& vessels,
                                                                  const core::RigidTransform& pose);

/// Distance of each point of the deformed tree from the rigid one, as both are drawn, and the end of the color scale.
struct MotionMap {
    std::map<int, std::vector<double>>
        distanceMm;   ///< by branch id; perpendicular to the ray if found from one view, else in 3-D
    double largestMm = 0.0;
    double scaleMaximumMm = 0.0;
};

/// Vessels of a view as drawn at a pose.
struct DrawnVessels {
    std::shared_ptr<const core::DeformableResult> known;   ///< see drawableDeformation
    VesselShape shape = VesselShape::Rigid;   ///< `Deformed` only if a deformation is known
    std::optional<int> otherFrame;   ///< frame in which the deformation was found, if another one is shown
    core::VesselTree tree;   ///< all branches, in patient axes at that pose
    MotionMap motion;   ///< of `known`
};
DrawnVessels drawnVessels(const core::View& view, const core::Vessels& vessels, const core::RigidTransform& pose,
                          VesselShape wanted);

/// Image captions on the vessel shape if a deformation is known: deformed and by how much, or rigid, and that one view
/// does not determine the depth. Empty if none is known.
core::Messages shapeLines(const DrawnVessels& drawn);

/// Heading of the color scale of a displacement map.
core::Message motionHeading();

}   // namespace angiopose::app
