#pragma once

#include "core/case/case.h"
#include "core/registration/deformable/deformed_tree.h"
#include "core/registration/registration.h"

#include <cmath>
#include <memory>

namespace angiopose::test {

/// The case as if a registration had found the pose of its shown view and deformed vessels: each branch displaced along
/// its length by up to `maxMm` across the ray, in one view.
inline core::Case withDeformedVessels(core::Case session, double maxMm)
{
    core::View& view = session.shown();
    core::RegistrationResult result;
    result.method = "angiopose";
    result.cameraFromPatient = view.cameraFromPatient;
    auto deformed = std::make_shared<core::DeformableResult>();
    deformed->verdict = core::DeformationVerdict::Deformed;
    deformed->cameraFromPatient = view.cameraFromPatient;
    deformed->viewPoses = {view.cameraFromPatient};
    const Eigen::Vector3d acrossInPatient = view.cameraFromPatient.rotation.transpose() * Eigen::Vector3d::UnitX();
    for (const core::VesselBranch& branch : session.vessels.tree->branches) {
        core::BranchMotion& motion = deformed->branches.emplace_back();
        motion.branchId = branch.id;
        const auto count = branch.pointsInPatient.size();
        for (std::size_t i = 0; i < count; ++i) {
            const double along = static_cast<double>(i) / static_cast<double>(count - 1);
            motion.displacementMm.emplace_back(maxMm * along * acrossInPatient);
        }
        motion.covariance.assign(count, Eigen::Vector3d(0.04, 0.04, 9.0).asDiagonal());
        core::roundMotion(motion);
    }
    deformed->largestMotionMm = maxMm;
    result.deformed = deformed;
    view.result = result;
    return session;
}

}   // namespace angiopose::test
