#pragma once

#include "core/case/case.h"
#include "core/registration/deformable/bent_tree.h"
#include "core/registration/registration.h"

#include <cmath>
#include <memory>

namespace angiopose::test {

/// The case as if a run had found its shown view's pose and vessels that are bent there: each branch along its length
/// by up to `mostMm` across the ray, in one view.
inline core::Case withBentVessels(core::Case theCase, double mostMm)
{
    core::View& view = theCase.shown();
    core::RegistrationResult result;
    result.method = "angiopose";
    result.cameraFromPatient = view.cameraFromPatient;
    auto bent = std::make_shared<core::DeformableResult>();
    bent->verdict = core::BendVerdict::Bent;
    bent->cameraFromPatient = view.cameraFromPatient;
    bent->viewPoses = {view.cameraFromPatient};
    const Eigen::Vector3d acrossInPatient = view.cameraFromPatient.rotation.transpose() * Eigen::Vector3d::UnitX();
    for (const core::VesselBranch& branch : theCase.vessels.tree->branches) {
        core::BranchMotion& motion = bent->branches.emplace_back();
        motion.branchId = branch.id;
        const auto count = branch.pointsInPatient.size();
        for (std::size_t i = 0; i < count; ++i) {
            const double along = static_cast<double>(i) / static_cast<double>(count - 1);
            motion.displacementMm.emplace_back(mostMm * along * acrossInPatient);
        }
        motion.covariance.assign(count, Eigen::Vector3d(0.04, 0.04, 9.0).asDiagonal());
        core::roundMotion(motion);
    }
    bent->largestMotionMm = mostMm;
    result.bent = bent;
    view.result = result;
    return theCase;
}

}   // namespace angiopose::test
