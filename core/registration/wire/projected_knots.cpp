#include "core/registration/wire/projected_knots.h"

#include <algorithm>

namespace angiopose::core {

ProjectedKnots projectWireKnots(const TreeKnots& knots, const std::vector<std::size_t>& which,
                                const ProjectionCamera& camera, const RigidTransform& cameraFromPatient, double depthMm)
{
    const Eigen::Vector2d farAway(-1e6, -1e6);
    ProjectedKnots seen;
    seen.mmPerPx = millimetersPerPixel(camera, std::max(minProjectableDepthMm, depthMm));
    seen.pixels.reserve(which.size());
    seen.radiusMm.reserve(which.size());
    for (const std::size_t knot : which) {
        seen.pixels.push_back(project(camera, cameraFromPatient * knots.places[knot]).value_or(farAway));
        seen.radiusMm.push_back(knots.radiusMm[knot]);
    }
    return seen;
}

}   // namespace angiopose::core
