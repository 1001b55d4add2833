#include "core/registration/wire/projected_knots.h"

#include <algorithm>

namespace angiopose::core {

ProjectedKnots projectWireKnots(const TreeKnots& knots, const std::vector<std::size_t>& knotIndices,
                                const ProjectionCamera& camera, const RigidTransform& cameraFromPatient, double depthMm)
{
    const Eigen::Vector2d farAway(-1e6, -1e6);
    ProjectedKnots projected;
    projected.mmPerPx = millimetersPerPixel(camera, std::max(minProjectableDepthMm, depthMm));
    projected.pixels.reserve(knotIndices.size());
    projected.radiusMm.reserve(knotIndices.size());
    for (const std::size_t knot : knotIndices) {
        projected.pixels.push_back(project(camera, cameraFromPatient * knots.positions[knot]).value_or(farAway));
        projected.radiusMm.push_back(knots.radiusMm[knot]);
    }
    return projected;
}

}   // namespace angiopose::core
