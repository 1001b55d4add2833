#include "core/case/known_bend.h"

#include "core/registration/deformable/bent_tree.h"

namespace angiopose::core {

std::shared_ptr<const DeformableResult> knownBend(const View& view, const Vessels& vessels, const RigidTransform& pose)
{
    if (!view.result || !view.result->bent || !vessels.tree) {
        return nullptr;
    }
    const DeformableResult& bent = *view.result->bent;
    const bool isSeen = bent.verdict != BendVerdict::Rigid && bent.stopReason != StopReason::StoppedByUser;
    const bool isHere = pose.matrix() == view.result->cameraFromPatient.matrix();
    return isSeen && isHere && isOf(*vessels.tree, bent) ? view.result->bent : nullptr;
}

}   // namespace angiopose::core
