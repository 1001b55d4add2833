#include "core/case/known_deformation.h"

#include "core/registration/deformable/deformed_tree.h"

namespace angiopose::core {

namespace {

std::shared_ptr<const DeformableResult> trackedDeformation(const View& view, const VesselTree& tree,
                                                           const RigidTransform& pose)
{
    const TrackedRunFrame* known = findDeformedFrame(view.followed, pose);
    return known && isCompatible(tree, *known->deformed) ? known->deformed : nullptr;
}

}   // namespace

std::shared_ptr<const DeformableResult> knownDeformation(const View& view, const Vessels& vessels,
                                                         const RigidTransform& pose)
{
    if (!vessels.tree) {
        return nullptr;
    }
    if (auto followed = trackedDeformation(view, *vessels.tree, pose)) {
        return followed;
    }
    if (!view.result || !view.result->deformed) {
        return nullptr;
    }
    const DeformableResult& deformed = *view.result->deformed;
    const bool isAtResultPose = pose.matrix() == view.result->cameraFromPatient.matrix();
    return isDeformed(deformed) && isAtResultPose && isCompatible(*vessels.tree, deformed) ? view.result->deformed
                                                                                           : nullptr;
}

}   // namespace angiopose::core
