#include "core/case/known_bend.h"

#include "core/registration/deformable/bent_tree.h"

namespace angiopose::core {

namespace {

std::shared_ptr<const DeformableResult> followedBend(const View& view, const VesselTree& tree,
                                                     const RigidTransform& pose)
{
    const FollowedFrame* known = bendAt(view.followed, pose);
    return known && isOf(tree, *known->bent) ? known->bent : nullptr;
}

}   // namespace

std::shared_ptr<const DeformableResult> knownBend(const View& view, const Vessels& vessels, const RigidTransform& pose)
{
    if (!vessels.tree) {
        return nullptr;
    }
    if (auto followed = followedBend(view, *vessels.tree, pose)) {
        return followed;
    }
    if (!view.result || !view.result->bent) {
        return nullptr;
    }
    const DeformableResult& bent = *view.result->bent;
    const bool isHere = pose.matrix() == view.result->cameraFromPatient.matrix();
    return isBent(bent) && isHere && isOf(*vessels.tree, bent) ? view.result->bent : nullptr;
}

}   // namespace angiopose::core
