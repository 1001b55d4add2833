#pragma once

#include "core/case/case.h"
#include "core/support/message.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::app {

/// Which vessels lie on an image: as the rigid pose has them, or as bending found them, where it did.
enum class VesselShape { Rigid, Deformed };

/// What bending found for a view and can be drawn where its vessels are shown at `pose`: that is the pose from which it
/// was found, it is of this tree, and there is something to see. Else null.
std::shared_ptr<const core::DeformableResult> drawableDeformation(const core::View& view, const core::Vessels& vessels,
                                                                  const core::RigidTransform& pose);

/// How far each point of the bent tree lies from the rigid one as both are drawn, and where the colours of it end.
struct MotionMap {
    std::map<int, std::vector<double>>
        distanceMm;   ///< by branch; across the ray where one view told it, else in space
    double largestMm = 0.0;
    double scaleMaximumMm = 0.0;
};

/// The vessels of a view as they are drawn at a pose.
struct DrawnVessels {
    std::shared_ptr<const core::DeformableResult> known;   ///< see drawableDeformation
    VesselShape shape = VesselShape::Rigid;   ///< bent only where that is known
    std::optional<int> otherFrame;   ///< of the run in which it was found, where another one is shown
    core::VesselTree tree;   ///< all branches, in patient axes at that pose
    MotionMap motion;   ///< of `known`
};
DrawnVessels drawnVessels(const core::View& view, const core::Vessels& vessels, const core::RigidTransform& pose,
                          VesselShape wanted);

/// What a picture says of its vessels where bent ones are known: bent by how much, or rigid, and that one view does not
/// tell the depth. Nothing where none are known.
core::Messages shapeLines(const DrawnVessels& drawn);

/// What stands above the scale of a motion map.
core::Message motionHeading();

}   // namespace angiopose::app
